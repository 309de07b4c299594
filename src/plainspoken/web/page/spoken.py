"""What was understood of a sentence, as HTML: marks in it, what it means, and small pictures."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from plainspoken.language.emphasis import Emphasis, Weight
from plainspoken.language.example import Example, Examples
from plainspoken.language.extracted import ReferringExpression
from plainspoken.logic.trace import Letter
from plainspoken.web.page.markup import Html, tag
from plainspoken.world.landmark import Landmarks, LandmarkType

_BEAD, _ROW = 112.0, 46.0
_SIGNS = {
    LandmarkType.LOCATION: "stop",
    LandmarkType.CONDITION: "fact",
    LandmarkType.ACTION: "deed",
}
_WEIGHTS = {
    Weight.NEGATION: "negation",
    Weight.LIMIT: "limit",
    Weight.NUMBER: "number",
    Weight.UNCLEAR: "unclear?",
}


def weighed(text: str, marks: Sequence[Emphasis]) -> Html:
    """What was heard, each word that turns its meaning round marked with the reason."""
    inside: list[str] = [tag("span", "I heard: ", class_="note")]
    end = 0
    for each in sorted(marks, key=lambda mark: (mark.start, mark.end)):
        if not end <= each.start < each.end <= len(text):
            continue  # what is weighty and unclear is marked as weighty
        inside.append(text[end : each.start])
        word = tag("mark", text[each.start : each.end])
        why = tag("small", _WEIGHTS[each.weight], class_="meant")
        inside.append(tag("span", word, why, class_=f"reference weight {each.weight}"))
        end = each.end
    inside.append(text[end:])
    return tag("p", *inside, class_="utterance")


def marked(
    utterance: str, expressions: Sequence[ReferringExpression], landmarks: Landmarks
) -> Html:
    """A sentence with a button for each piece that speaks of something; picked is its place."""
    inside: list[str] = []
    end = 0
    for index, each in _apart(expressions):
        landmark = landmarks.get(each.symbol)
        meant = landmark.description if landmark else each.symbol
        inside.append(utterance[end : each.start])
        inside.append(
            tag(
                "button",
                tag("mark", utterance[each.start : each.end]),
                tag("small", meant, class_="meant"),
                type="button",
                class_="reference",
                data_pick=str(index),
                aria_label=f"“{each.text}” is understood as {meant}: choose something else",
            )
        )
        end = each.end
    inside.append(utterance[end:])
    return tag("p", *inside, class_="utterance")


def _apart(
    expressions: Sequence[ReferringExpression],
) -> Iterator[tuple[int, ReferringExpression]]:
    """Those that do not overlap an earlier one, in the order of the sentence."""
    end = 0
    for index, each in sorted(enumerate(expressions), key=lambda one: one[1].start):
        if each.start >= end:
            yield index, each
            end = each.end


def pictured(found: Examples, landmarks: Landmarks) -> Html | None:
    """Traces that would do and traces that would not, each a row of instants."""
    rows = [
        tag(
            "li",
            tag("span", "✓ " if good else "× ", aria_hidden="true"),
            tag("span", "would do: " if good else "would not do: ", class_="spoken-only"),
            _trace(each, landmarks, good=good),
            class_="good" if good else "bad",
        )
        for good, some in ((True, found.accepted), (False, found.rejected))
        for each in some
    ]
    return (
        tag("ul", *rows, class_="examples", tabindex="0", aria_label="examples") if rows else None
    )


def _trace(example: Example, landmarks: Landmarks, *, good: bool) -> Html:
    """One trace as beads on a string; its title says it in words."""
    shown = list(example.trace)
    while len(shown) > 1 and not shown[0]:
        shown.pop(0)
    most = max(len(letter) for letter in shown)
    width, height = _BEAD * len(shown), 34 + 18.0 * max(most, 1)
    string = tag("line", x1=_BEAD / 2, y1=14.0, x2=width - _BEAD / 2, y2=14.0, class_="string")
    beads = [bead for i, letter in enumerate(shown) for bead in _bead(i, letter, landmarks)]
    return tag(
        "svg",
        tag("title", example.english),
        string,
        *beads,
        viewBox=f"0 0 {width:g} {height:g}",
        style=f"width:{width:g}px",
        class_="trace good" if good else "trace bad",
        role="img",
    )


def _bead(place: int, letter: Letter, landmarks: Landmarks) -> Iterator[Html]:
    x = _BEAD * (place + 0.5)
    names = sorted(letter)
    kinds = [landmarks[name].type for name in names if name in landmarks]
    kind = _SIGNS[kinds[0]] if kinds else "nothing"
    if kind == "deed":
        yield tag("polygon", points=f"{x:g},4 {x + 10:g},14 {x:g},24 {x - 10:g},14",
                  class_=f"bead {kind}")  # fmt: skip
    elif kind == "stop":
        yield tag("rect", x=x - 9, y=5.0, width=18.0, height=18.0, rx=4.0, class_=f"bead {kind}")
    else:
        yield tag("circle", cx=x, cy=14.0, r=9.0 if names else 4.0, class_=f"bead {kind}")
    for row, name in enumerate(names):
        text = landmarks[name].description if name in landmarks else name
        short = text.removeprefix("to ").removeprefix("the ")
        cut = short if len(short) <= 17 else f"{short[:16]}…"
        yield tag("text", cut, x=x, y=42 + 18.0 * row, text_anchor="middle")
