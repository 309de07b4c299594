"""Words are cut into the longest pieces that are known, from the left."""

from hypothesis import given
from hypothesis import strategies as st

from plainspoken.language.wordpiece import END, START, UNKNOWN, Pieces

KNOWN = [UNKNOWN, START, END, "un", "unlock", "##ed", "##lock", "##e", "##d", "a", "##a"]


def test_the_longest_piece_goes_first() -> None:
    pieces = Pieces(KNOWN)
    assert [KNOWN[number] for number in pieces.of("unlocked")] == ["unlock", "##ed"]


def test_a_word_that_cannot_be_cut_is_unknown_as_a_whole() -> None:
    assert [KNOWN[number] for number in Pieces(KNOWN).of("unzip")] == [UNKNOWN]


@given(st.text(alphabet="aunlocked", min_size=1, max_size=12))
def test_pieces_put_together_are_the_word(word: str) -> None:
    found = [KNOWN[number] for number in Pieces(KNOWN).of(word)]
    assert found == [UNKNOWN] or "".join(found).replace("##", "") == word
