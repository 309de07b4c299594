"""Nothing impossible is accepted: 45 sentences that no mission of the vineyard can come of."""

import time
from pathlib import Path

import pytest

from plainspoken.language.extraction import Status, extract
from plainspoken.language.grounding import Vocabulary
from plainspoken.world.landmark import read_landmarks

VINEYARD = Vocabulary.of(
    read_landmarks(Path(__file__).parents[2] / "examples" / "vineyard" / "landmarks.json")
)
IMPOSSIBLE = """
Go to line 12.
Visit line 1 and then line 99.
Go to the greenhouse.
Never enter the office.
Wait at the gate until the van arrives.
Harvest an apple.
If the tank is empty, go to line 1.
Call the fire brigade when the box is full.
Dig a hole at line 2.
Paint the warehouse blue.
Sing a song at line 1.
Make sure grape 17 is ripe.
Bring me a cup of coffee.
What time is it?
How are you today?
Where is the robot?
Is line 2 cleared?
Tell me a joke.
The weather is nice.
The box is full.
Line 2 is cleared and grape 1 is ripe.
Thank you very much.
You may visit line 1.
Feel free to harvest a grape.
You do not have to visit line 2.
Visit line 1 and never visit line 1.
Never leave line 1 and go to line 2 and never go to line 2.
Never harvest a grape, but harvest a grape exactly twice.
Visit line 3 exactly once and at least three times.
Visit line 1 before line 2 and line 2 before line 1.
Harvest a grape at least twice and at most once.
Do not visit line 2 until line 1 is cleared, never clear line 1, and visit line 2.
Keep the box full at all times and make sure the box is not full.
Visit line 0, but never enter any line.
Visit every line and avoid line 2.
Make sure the box is full and never let the box be full.
blargh fnord zyx
Allez à la ligne 1.
Geh zur Reihe 2 und dann zum Lager.
ve a la fila dos
去第一行
иди на линию 1
🍇🍇🍇
12345 67890
if then else while do
"""


@pytest.mark.parametrize("sentence", IMPOSSIBLE.strip().splitlines())
def test_what_is_impossible_is_refused_with_a_reason(sentence: str) -> None:
    extraction = extract(sentence, VINEYARD)
    assert extraction.status is Status.REJECT
    assert extraction.formula is None
    assert extraction.reason


@pytest.mark.parametrize(
    ("sentence", "reason"),
    [
        ("", "Nothing was said."),
        ("a" * 10_000, "That is 10000 characters long"),
        ("visit line 1 and " * 600, "Say it in shorter pieces."),
        ("🤖 🍇 ➡️ 🏠", "I found nothing"),
        ("اذهب إلى الصف الأول", "I understand English only."),
        ("לך לשורה 1", "I understand English only."),
        ("idź do rzędu pierwszego", "I understand English only."),
        ("ไปที่แถว", "I understand English only."),
        ("What is the robot doing?", "That is a question."),
        ("Fold the laundry.", "I found nothing there that this robot can visit, watch or do"),
    ],
    ids=["empty", "long", "longer", "emoji", "arabic", "hebrew", "polish", "thai", "asked", "home"],
)
def test_odd_input_is_refused_politely_and_at_once(sentence: str, reason: str) -> None:
    extract("visit line 1", VINEYARD)  # the dictionary loads once
    started = time.perf_counter()
    extraction = extract(sentence, VINEYARD)
    assert time.perf_counter() - started < 1
    assert extraction.status is Status.REJECT
    assert reason in (extraction.reason or "")
