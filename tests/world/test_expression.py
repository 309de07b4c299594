"""The outer form of PDDL: lists with their lines, typed lists, and where a parenthesis is amiss."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plainspoken.errors import InputFileError
from plainspoken.world.expression import DEEPEST, Expression, PddlFile, parse_expression


def test_a_file_is_lists_of_lower_case_names_with_the_line_where_each_begins() -> None:
    root = parse_expression("\n(Define (DOMAIN d)\n\n  (:Types A-b))", "d.pddl")
    assert root == ["define", ["domain", "d"], [":types", "a-b"]]
    assert (root.line, root[1].line, root[2].line) == (2, 2, 4)


def test_a_comment_ends_with_its_line_and_may_hold_parentheses() -> None:
    root = parse_expression("(a ; (b\n c;)\n;;\n)", "d.pddl")
    assert root == ["a", "c"]


def test_an_expression_is_shown_as_it_is_written() -> None:
    text = "(a (b ?x) () (- c))"
    assert str(parse_expression(text, "d.pddl")) == text


SECTIONS = """(define (domain d)
  (:predicates (p) (q))
  (:action a
    :parameters ()
    :effect (and (p) (q){one})
  )
  (:action b
    :parameters ()
    :effect (p)){two}
  (:action c :parameters () :effect (q))
){three}
"""


def where(text: str) -> tuple[str, int | None]:
    with pytest.raises(InputFileError) as caught:
        parse_expression(text, "d.pddl")
    return caught.value.what, caught.value.line


def sections(one: str = "", two: str = "", three: str = "") -> str:
    return SECTIONS.format(one=one, two=two, three=three)


@pytest.mark.parametrize(
    ("text", "line"),
    [
        (sections(one="("), 3),
        (sections().replace("(and (p) (q))", "(and (p) (q)"), 3),
        (sections(two="("), 9),
        (sections().replace("(:action c :parameters ()", "(:action c :parameters ("), 10),
        (sections().removesuffix(")\n"), 1),
        ("(a\n(b\n(c", 3),
        ("(", 1),
    ],
)
def test_a_parenthesis_that_is_never_closed_is_looked_for_where_it_begins(
    text: str, line: int
) -> None:
    assert where(text) == ("a '(' is never closed", line)


@pytest.mark.parametrize(
    ("text", "line"),
    [
        (sections(one=")"), 6),
        (sections(two=")"), 9),
        (sections(two="))"), 9),
        (sections(three="\n)"), 12),
        (")", 1),
        ("\n\n)(a)", 3),
        ("(define (domain d))\n(:types a)", 1),
    ],
)
def test_a_parenthesis_too_many_is_looked_for_where_it_ends_something(text: str, line: int) -> None:
    assert where(text) == ("a ')' too many", line)


@pytest.mark.parametrize(
    "text", ["", "  \n ; only a comment\n", "define", "a (b)", "\x00\x01", "(a) b"]
)
def test_what_is_no_single_list_is_no_pddl(text: str) -> None:
    what, _ = where(text)
    assert what == "not a PDDL file: expected one (define ...)"


def test_domain_and_problem_in_one_file_are_told_apart_at_the_second_line() -> None:
    assert where("(define (domain d))\n(define (problem p))") == ("more than one (define ...)", 2)


@pytest.mark.parametrize("closed", ["", ")"])
def test_lists_nested_beyond_reason_are_refused(closed: str) -> None:
    what, line = where("\n" + "(" * 100_000 + closed * 100_000)
    assert what == f"nested deeper than {DEEPEST}"
    assert line == 2


@given(st.text(alphabet="()a;: \n", max_size=30))
def test_any_text_is_read_or_refused_with_a_line_of_it(text: str) -> None:
    line: int | None = 1
    try:
        assert isinstance(parse_expression(text, "d.pddl"), Expression)
    except InputFileError as error:
        line = error.line
    assert line is None or 1 <= line <= text.count("\n") + 1


# Files


@pytest.mark.parametrize(
    "content",
    [
        b"(define (domain d)\r\n  (:types a))\r\n",
        b"\xef\xbb\xbf(define (domain d)\n  (:types a))",
        b"(define (domain d)\r  (:types a))",
    ],
    ids=["CRLF", "BOM", "CR"],
)
def test_a_file_of_another_system_reads_the_same_with_the_same_lines(
    tmp_path: Path, content: bytes
) -> None:
    path = tmp_path / "d.pddl"
    path.write_bytes(content)
    root = PddlFile(path).root
    assert root == ["define", ["domain", "d"], [":types", "a"]]
    assert root[2].line == 2


def test_a_binary_file_is_refused_as_such(tmp_path: Path) -> None:
    path = tmp_path / "d.pddl"
    path.write_bytes(b"\x7fELF\xff\xfe(")
    with pytest.raises(InputFileError, match="not a text file"):
        PddlFile(path)


def test_a_missing_file_and_a_folder_are_refused_with_their_name(tmp_path: Path) -> None:
    for path in (tmp_path / "none.pddl", tmp_path):
        with pytest.raises(InputFileError, match="cannot read the file") as caught:
            PddlFile(path)
        assert caught.value.where == str(path)


# Typed lists


@pytest.fixture
def file(tmp_path: Path) -> PddlFile:
    path = tmp_path / "d.pddl"
    path.write_text("()")
    return PddlFile(path)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("()", []),
        ("(a b)", [("a", "object"), ("b", "object")]),
        ("(a b - t c)", [("a", "t"), ("b", "t"), ("c", "object")]),
        ("(a - t b - u)", [("a", "t"), ("b", "u")]),
        ("(a - (either t u) b)", [("a", "t", "u"), ("b", "object")]),
        ("(- t)", []),
    ],
)
def test_a_type_belongs_to_all_names_before_it_that_have_none(
    file: PddlFile, text: str, expected: list[tuple[str, ...]]
) -> None:
    words = parse_expression(text, "d.pddl")
    assert [(name, *types) for name, types in file.typed(words, words)] == expected


@pytest.mark.parametrize("text", ["(a -)", "(a - (t))", "((a) - t)", "(a -t)", "(a - (or t u))"])
def test_a_typed_list_that_is_none_is_refused(file: PddlFile, text: str) -> None:
    words = parse_expression(text, "d.pddl")
    with pytest.raises(InputFileError, match="expected a "):
        list(file.typed(words, words))


def test_a_parameter_without_a_question_mark_is_refused(file: PddlFile) -> None:
    with pytest.raises(InputFileError, match=r"expected a variable such as \?x, got l"):
        file.parameters(["?r", "l"], Expression())
