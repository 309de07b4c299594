import pytest

from plainspoken.errors import PlainspokenError
from plainspoken.web.address import Names, at, is_loopback, is_same_origin, refuse_exposure

WIDE = "0.0.0.0"  # noqa: S104 - nothing listens there


@pytest.mark.parametrize("host", ["127.0.0.1", "127.8.0.1", "localhost", "LOCALHOST", "::1"])
def test_this_computer_needs_no_tokens(host: str) -> None:
    assert is_loopback(host)
    refuse_exposure(host, [], guarded=False)


@pytest.mark.parametrize(
    "host", [WIDE, "::", "192.168.1.2", "farm.example", "", "localhost.evil.example"]
)
def test_listening_to_more_than_this_computer_needs_tokens(host: str) -> None:
    refuse_exposure(host, [], guarded=True)
    with pytest.raises(PlainspokenError, match="could command") as caught:
        refuse_exposure(host, [], guarded=False)
    assert "--tokens" in str(caught.value)


def test_a_name_of_ones_own_needs_tokens_too() -> None:
    with pytest.raises(PlainspokenError, match="reaches farm"):
        refuse_exposure("127.0.0.1", ["farm.example"], guarded=False)


@pytest.mark.parametrize("host", ["127.0.0.1:80", "localhost", "[::1]:8765", "LocalHost:1"])
def test_this_computer_is_called_by_its_own_names(host: str) -> None:
    assert Names.of("127.0.0.1").cover(host)


@pytest.mark.parametrize(
    "host",
    [None, "", "evil.example", "192.168.1.2", "127.0.0.1.evil.example", "localhost@evil.example",
     "127.0.0.1:80:80", "evil.example#localhost", "localhost:port", "a b", "127.0.0.1\r\nx"],
)  # fmt: skip
def test_other_names_are_not_ours(host: str | None) -> None:
    assert not Names.of("127.0.0.1").cover(host)


def test_a_wide_server_answers_to_addresses_and_given_names() -> None:
    names = Names.of(WIDE, ["farm.example"])
    assert all(map(names.cover, ["192.168.1.2:8765", "[fe80::1]", "farm.example", "localhost"]))
    assert not names.cover("evil.example")


@pytest.mark.parametrize(
    ("origin", "host"),
    [("http://localhost:8765", "localhost:8765"), ("https://farm.example", "farm.example"),
     ("http://FARM.example:80", "farm.example"), ("https://farm.example", "farm.example:443")],
)  # fmt: skip
def test_a_page_of_ours_has_our_host(origin: str, host: str) -> None:
    assert is_same_origin(origin, host)


@pytest.mark.parametrize(
    ("origin", "host"),
    [("null", "localhost"), ("http://localhost:3000", "localhost:8765"), ("", "localhost"),
     ("http://evil.example", "localhost"), ("file://localhost", "localhost"),
     ("http://[", "localhost"), ("http://localhost", None)],
)  # fmt: skip
def test_other_pages_are_not_ours(origin: str, host: str | None) -> None:
    assert not is_same_origin(origin, host)


def test_an_address_of_colons_stands_in_brackets() -> None:
    assert (at("::1"), at("127.0.0.1")) == ("[::1]", "127.0.0.1")
