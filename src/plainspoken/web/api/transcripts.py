"""What is said in a recording, to be looked at before anything is made of it."""

from __future__ import annotations

import asyncio
from typing import Annotated

from fastapi import APIRouter, HTTPException, Query, Request

from plainspoken.web.api.calling import LISTEN, TheOffice, TheOperator
from plainspoken.web.api.model import Transcript
from plainspoken.web.api.office import Office

router = APIRouter(tags=["speech"])

_WAV = {"audio/wav": {"schema": {"type": "string", "format": "binary"}}}
Name = Annotated[str | None, Query(min_length=1, max_length=300)]


@router.post(
    "/transcripts",
    dependencies=[LISTEN],
    openapi_extra={"requestBody": {"required": True, "content": _WAV}},
)
async def transcribe(
    request: Request,
    office: TheOffice,
    caller: TheOperator,
    place: Name = None,
    mission: Name = None,
) -> Transcript:
    """The text of a WAV file of a minute at most, with the words that deserve a second look.

    Name the place or the mission that it is about, whose words are then expected. Nothing is made
    of the text: show it to whoever spoke, and send what they agree to.
    """
    content = await request.body()
    kind = request.headers.get("content-type", "")
    found = await asyncio.to_thread(_heard, office, content, kind, (place, mission), caller.name)
    return Transcript.model_validate(found)


def _heard(
    office: Office, content: bytes, kind: str, about: tuple[str | None, str | None], who: str
) -> object:
    place, mission = about
    if place is not None and mission is None:
        site = office.desk.place(place)
    elif mission is not None and place is None:
        site = office.desk.site(mission)
    else:
        raise HTTPException(422, "name the place, or the mission, that it is about")
    if office.hearing is None:
        raise HTTPException(503, "speech is not understood on this server")
    return office.hearing.hear(content, kind, site, who).to_json()
