import os
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plainspoken.errors import InputFileError, PlainspokenError
from plainspoken.web.access import (
    Access,
    Caller,
    GrantFile,
    Role,
    append_grant,
    chosen_grants,
    grants_in,
    new_grant,
)


def one(role: Role = Role.OPERATOR, name: str = "ada") -> tuple[str, Access]:
    token, grant = new_grant(role, name)
    return token, Access(lambda: (grant,))


def test_a_token_says_who_somebody_is_and_what_they_may() -> None:
    token, access = one(Role.VIEWER)
    assert access.by_token(token) == Caller("ada", Role.VIEWER)
    assert not Caller("ada", Role.VIEWER).may_command
    assert access.anyone() is None


@given(st.text())
def test_nothing_else_is_a_token_or_a_login(shown: str) -> None:
    _, access = one()
    assert access.by_token(shown) is None
    assert access.login(shown) is None
    assert access.by_cookie(shown) is None


def test_the_file_of_tokens_holds_no_token(tmp_path: Path) -> None:
    token, grant = new_grant(Role.OPERATOR, "ada")
    append_grant(tmp_path / "tokens", grant)
    assert token not in (tmp_path / "tokens").read_text()
    assert grants_in(str(grant), "here") == (grant,)


def test_a_login_is_the_callers_until_it_ends() -> None:
    now = [1000.0]
    token, grant = new_grant(Role.OPERATOR, "ada")
    access = Access(lambda: (grant,), lasts=60, now=lambda: now[0])
    found = access.login(token)
    assert found is not None
    cookie, caller = found
    assert access.by_cookie(cookie) == caller == Caller("ada", Role.OPERATOR, 1060)
    now[0] = 1060.0
    assert access.by_cookie(cookie) is None


def test_a_login_outlives_a_restart_and_ends_with_its_token() -> None:
    token, grant = new_grant(Role.OPERATOR, "ada")
    found = Access(lambda: (grant,)).login(token)
    assert found is not None
    assert Access(lambda: (grant,)).by_cookie(found[0]) is not None
    _, other = new_grant(Role.OPERATOR, "ada")
    assert Access(lambda: (other,)).by_cookie(found[0]) is None


def test_a_changed_login_is_none() -> None:
    token, access = one()
    found = access.login(token)
    assert found is not None
    name, until, rest = found[0].split(".", 2)
    assert access.by_cookie(f"{name}.{int(until) + 1}.{rest}") is None
    assert access.by_cookie(found[0][:-1] + ("0" if found[0][-1] != "0" else "1")) is None


def test_a_login_that_was_left_is_over() -> None:
    token, access = one()
    found = access.login(token)
    assert found is not None
    access.logout(found[0])
    assert access.by_cookie(found[0]) is None
    again = access.login(token)
    assert again is not None
    assert access.by_cookie(again[0]) is not None


def test_a_token_that_is_taken_out_of_the_file_ends_at_once(tmp_path: Path) -> None:
    file = tmp_path / "tokens"
    kept, grant = new_grant(Role.OPERATOR, "ada")
    gone, other = new_grant(Role.VIEWER, "bob")
    append_grant(file, grant)
    append_grant(file, other)
    access = Access(GrantFile(file))
    assert access.by_token(gone) == Caller("bob", Role.VIEWER)
    file.write_text(f"{grant}\n")
    assert access.by_token(gone) is None
    assert access.by_token(kept) == Caller("ada", Role.OPERATOR)


def test_nobody_comes_in_while_the_file_cannot_be_used(tmp_path: Path) -> None:
    file = tmp_path / "tokens"
    token, grant = new_grant(Role.OPERATOR, "ada")
    append_grant(file, grant)
    access = Access(GrantFile(file))
    file.unlink()
    with pytest.raises(InputFileError, match="cannot read"):
        access.by_token(token)


def test_a_file_that_others_can_read_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "tokens"
    append_grant(file, new_grant(Role.OPERATOR, "ada")[1])
    assert file.stat().st_mode & 0o777 == 0o600
    for mode in (0o640, 0o604, 0o620):
        file.chmod(mode)
        with pytest.raises(InputFileError, match="others") as caught:
            GrantFile(file)
        assert "chmod 600" in str(caught.value)


def test_a_file_of_somebody_else_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "tokens"
    append_grant(file, new_grant(Role.OPERATOR, "ada")[1])
    owner = os.geteuid()
    monkeypatch.setattr(os, "geteuid", lambda: owner + 1)
    with pytest.raises(InputFileError, match="others"):
        GrantFile(file)


@pytest.mark.parametrize("line", ["admin ada " + "0" * 64, "operator ada", "operator ada secret!"])
def test_a_bad_line_is_named_without_saying_it_aloud(tmp_path: Path, line: str) -> None:
    with pytest.raises(InputFileError, match="expected") as caught:
        grants_in(f"# people\n\n{line}\n", tmp_path / "tokens")
    assert caught.value.line == 3
    assert line not in str(caught.value)


def test_each_name_has_one_token(tmp_path: Path) -> None:
    file = tmp_path / "tokens"
    append_grant(file, new_grant(Role.OPERATOR, "ada")[1])
    before = file.read_text()
    with pytest.raises(InputFileError, match="two tokens of ada"):
        append_grant(file, new_grant(Role.VIEWER, "ada")[1])
    assert file.read_text() == before


@pytest.mark.parametrize("name", ["", "a b", "a\nb", "x" * 65, "#a"])
def test_a_name_fits_into_a_line(name: str) -> None:
    with pytest.raises(PlainspokenError, match="called"):
        new_grant(Role.VIEWER, name)


def test_tokens_may_come_from_the_environment() -> None:
    token, grant = new_grant(Role.OPERATOR, "ada")
    _, other = new_grant(Role.VIEWER, "bob")
    grants = chosen_grants(None, f"{grant};{other}")
    assert Access(grants).by_token(token) == Caller("ada", Role.OPERATOR)
    assert chosen_grants(None, None) is chosen_grants(None, "") is None
    with pytest.raises(InputFileError, match="nobody"):
        chosen_grants(None, "# none")


def test_an_empty_file_lets_nobody_in_rather_than_everybody(tmp_path: Path) -> None:
    file = tmp_path / "tokens"
    file.touch(mode=0o600)
    with pytest.raises(InputFileError, match="nobody"):
        chosen_grants(file, None)
