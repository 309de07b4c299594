from html.parser import HTMLParser

import pytest
from hypothesis import given
from hypothesis import strategies as st

pytest.importorskip("nicegui", reason="the page is an extra: pip install 'plainspoken[web]'")

from plainspoken.web.page.markup import Html, joined, tag


class _Heard(HTMLParser):
    """What a browser makes of HTML: the tags, and the text."""

    def __init__(self) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.attributes: list[tuple[str, str | None]] = []
        self.text = ""

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.attributes += attrs

    def handle_data(self, data: str) -> None:
        self.text += data


readable = st.text(
    st.characters(exclude_categories=("Cs", "Cc")) | st.sampled_from("<>&\"'`/="), max_size=40
)


@given(readable, readable)
def test_whatever_a_text_is_it_makes_no_element_and_no_attribute(text: str, title: str) -> None:
    heard = _Heard()
    heard.feed(tag("p", text, title=title))
    heard.close()
    assert heard.tags == ["p"]
    assert heard.attributes == [("title", title)]
    assert heard.text == text


def test_what_is_html_already_stays_as_it_is() -> None:
    assert tag("p", tag("b", "1 < 2")) == "<p><b>1 &lt; 2</b></p>"
    assert isinstance(joined(["a", Html("<br/>")]), Html)


def test_attributes_are_named_as_in_html_and_left_out_where_there_is_nothing() -> None:
    made = tag("g", class_="x", data_key="a b", hidden=True, style=None, open_=False, x=1.5)
    assert made == '<g class="x" data-key="a b" hidden x="1.5"></g>'
    assert tag("br") == "<br/>"
