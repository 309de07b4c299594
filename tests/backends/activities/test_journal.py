"""Notes are durable when `note` returns, and are there for the next process, in either store."""

from plainspoken.backends.activities.journal import Journal
from plainspoken.cli.store import open_store
from plainspoken.knowledge.store import Store


def test_the_last_note_counts_and_outlives_the_journal(store: Store, store_url: str) -> None:
    journal = Journal(store.database)
    assert journal.get("m/1", "action") is None
    journal.note("m/1", "action", "go")
    journal.note("m/1", "action", {"grüß": [1, None]})
    with open_store(store_url) as again:
        assert Journal(again.database).get("m/1", "action") == {"grüß": [1, None]}
        assert Journal(again.database).get("m/2", "action") is None


def test_two_programs_see_each_others_notes(store: Store, store_url: str) -> None:
    one = Journal(store.database)
    with open_store(store_url) as elsewhere:
        other = Journal(elsewhere.database)
        one.note("m/1", "action", "go")
        assert other.get("m/1", "action") == "go"
        other.note("m/1", "heard", value=True)
        assert one.get("m/1", "heard") is True
