"""Questions as people ask them, with the kind and the things that each is about."""

from functools import cache

import pytest
from tests.questions.missions import SETTINGS, accepted

from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.moment import lexicon_of
from plainspoken.questions.question import question_of

# question | kind | objects | actions or predicates that have to be among those found
VINEYARD = """
What are you doing? | now | |
What are you doing right now? | now | |
What are you up to? | now | |
What's going on? | now | |
What are you working on at the moment? | now | |
Can you tell me what you're doing? | now | |
What is your current task? | now | |
What action are you performing now? | now | |
Which task are you busy with? | now | |
And now? | now | |
What's happening? | now | |
Tell me what you are currently doing. | now | |
Describe the current situation. | now | |
What did you do so far? | past | |
What have you done? | past | |
What have you been doing? | past | |
What did you do last? | past | |
What was your last action? | past | |
What did you just do? | past | |
What happened so far? | past | |
Which actions have you already carried out? | past | |
Give me a summary of what you did. | past | |
Did you check grape 1? | past | g1 | check-grape
Have you harvested grapes 0 and 2? | past | g0 g2 | harvest-grape
Have you already picked grape 3? | past | g3 | harvest-grape
What did you do before checking grape 2? | past | g2 | check-grape
Where have you been? | past | |
What had you done before that? | past | |
Didn't you check grape two? | past | g2 | check-grape
Tell me everything you've done up to now. | past | |
What are you going to do next? | future | |
What will you do next? | future | |
What's next? | future | |
What is your plan? | future | |
What's your next step? | future | |
What will you do after that? | future | |
And then? | future | |
And after that? | future | |
What do you intend to do now? | future | |
What are you planning to do? | future | |
Will you harvest grape 3? | future | g3 | harvest-grape
Will the box be full? | future | b | full
Are you going to check grape 2? | future | g2 | check-grape
Where are you going? | future | |
What do you do after signing off line 1? | future | l1 | sign-off
What will happen next? | future | |
What's your next action and why? | why_action | |
Will line 3 ever be cleared? | future | l3 | cleared
Why? | why_action | |
Why are you doing that? | why_action | |
Why did you call the support robot? | why_action | sup | call-support
Why are you moving to line 2? | why_action | l2 | move
What are you doing that for? | why_action | |
What is the purpose of this? | why_action | |
How come you emptied the bin? | why_action | b | empty-box
For what reason did you drive to row 3? | why_action | l3 | move
Explain why you checked grape 1. | why_action | g1 | check-grape
Why didn't you harvest grape 1? | why_not | g1 | harvest-grape
Why don't you go to line 3 first? | why_not | l3 |
Why aren't you picking grape 2? | why_not | g2 | harvest-grape
Why not harvest grape 0? | why_not | g0 | harvest-grape
What stops you from emptying the box? | why_not | b | empty-box
Why is the box full? | why_happened | b | full
Why was grape 1 unripe? | why_happened | g1 | unripe
What went wrong with the support robot? | why_happened | sup |
When did you check grape 0? | when | g0 | check-grape
Since when is the box full? | when | b | full
How long ago did you sign off line 1? | when | l1 | sign-off
At what time did you call the support robot? | when | sup | call-support
When will you empty the box? | when | b | empty-box
When was line 2 cleared? | when | l2 | cleared
Is grape 1 ripe? | state | g1 | ripe
Is the box full? | state | b | full
Is the bin full? | state | b | full
Where are you? | state | |
Where are you now? | state | |
Where is the support robot? | state | sup |
Which lines are cleared? | state | | cleared
Which grapes are ripe? | state | | ripe
Which grapes haven't been checked? | state | | unchecked
How many ripe grapes did you find? | state | | ripe
How many lines are cleared? | state | | cleared
What do you know about grape 2? | state | g2 |
Are there any unripe grapes? | state | | unripe
Is grape 0 in the warehouse? | state | g0 wh | stored
Is your hand empty? | state | | hand-empty
Are you at line 2? | state | l2 | robot-at
What's in the box? | state | b | inside
Are grapes 1 to 3 ripe? | state | g1 g2 g3 | ripe
Tell me where the support robot is. | state | sup |
How far are you? | progress | |
Are you done? | progress | |
Are you finished yet? | progress | |
What's left to do? | progress | |
How much is left? | progress | |
How long will it take? | progress | |
How is it going? | progress | |
How many steps are left? | progress | |
Is everything on track? | progress | |
What is still open? | progress | |
When will you be done? | progress | |
What's your progress? | progress | |
What if grape 3 is unripe? | what_if | g3 | unripe
What happens if the box is full? | what_if | b | full
What will you do if the support robot doesn't come? | what_if | sup |
What would you do if grape 2 were ripe? | what_if | g2 | ripe
Suppose grape 1 is unknown, what then? | what_if | g1 | unknown
Are you keeping away from line 3? | constraint | l3 |
Have you avoided line 3? | constraint | l3 |
Did you break any rule? | constraint | |
Are you sticking to the rules? | constraint | |
Are you still staying away from row 2? | constraint | l2 |
How often did you call the support robot? | count_history | sup | call-support
How many times did you check grape 1? | count_history | g1 | check-grape
Have you ever been at line 3? | past | l3 |
How many actions have you done so far? | count_history | |
How many grapes did you harvest? | count_history | | harvest-grape
Was the box ever full? | past | b | full
I cleared line 2 myself. | report | l2 |
The box is full. | report | b | full
I have already harvested grape 3. | report | g3 | harvest-grape
FYI, the support robot is at line 1. | report | sup l1 |
Line 2 is done. | report | l2 |
Check grape 3. | command | g3 | check-grape
Go to line 2! | command | l2 |
Please harvest grape 1 | command | g1 | harvest-grape
Can you call the support robot? | command | sup | call-support
Stop! | command | |
Could you please check grape 2 next? | command | g2 | check-grape
Don't go to line 3. | command | l3 |
Hello! | chitchat | |
Thank you! | chitchat | |
How are you? | chitchat | |
Tell me a joke. | chitchat | |
What can I ask you? | chitchat | |
Who are you? | chitchat | |
"""
WAREHOUSE = """
What are you holding? | state | | holding
Is the door open? | state | | door-open
Is package 1 damaged? | state | p1 | damaged
Where is package 2? | state | p2 |
Did you scan p1? | past | p1 | scan
Will you pick up package 2? | future | p2 | pick-up
Why did you put down package 1? | why_action | p1 | put-down
Are your hands free? | state | | hands-free
Which packages have been scanned? | state | | scanned
Drive to the dock. | command | dock | drive
How often have you opened the door? | count_history | | open-door
When did you drop off package 1? | when | p1 |
"""
KITCHEN = """
Is plate 1 clean? | state | plate1 | clean
Which dishes are still dirty? | state | | dirty
Where's the red mug? | state | red-mug |
How many plates are clean? | state | | clean
Have you washed the red mug? | past | red-mug | wash
Why did you heat the water? | why_action | | heat-water
Is the water hot? | state | | water-hot
Wash plate 2, please. | command | plate2 | wash
Will you put away plate 1? | future | plate1 | put-away
Is plate 1 in the cupboard? | state | plate1 top-cupboard | in
"""


def rows(name: str, table: str) -> list[tuple[str, ...]]:
    found = []
    for line in table.strip().splitlines():
        text, kind, objects, words = (part.strip() for part in line.split("|"))
        found.append((name, text, kind, objects, words))
    return found


TABLE = rows("vineyard", VINEYARD) + rows("warehouse", WAREHOUSE) + rows("kitchen", KITCHEN)


@cache
def lexicon(name: str) -> Lexicon:
    return lexicon_of(accepted(SETTINGS[name]))


@pytest.mark.parametrize(("name", "text", "kind", "objects", "words"), TABLE)
def test_a_question_is_of_its_kind_and_about_its_things(
    name: str, text: str, kind: str, objects: str, words: str
) -> None:
    question = question_of(text, lexicon(name))
    about = question.referents
    assert (str(question.kind), set(about.objects)) == (kind, set(objects.split()))
    assert set(words.split()) <= {*about.actions, *about.predicates}


def test_the_table_is_not_small() -> None:
    assert len(TABLE) > 150
