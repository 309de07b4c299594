"""Logging in with a token, for people: one plain form, which needs no script."""

from __future__ import annotations

from html import escape
from urllib.parse import parse_qs

from starlette.requests import Request
from starlette.responses import HTMLResponse, RedirectResponse, Response
from starlette.routing import Route

from plainspoken.errors import PlainspokenError
from plainspoken.web.access import Access
from plainspoken.web.gate import COOKIE, LOGIN, LOGOUT, REFUSALS, address_of, login_cookie
from plainspoken.web.rate import Rates, TooManyError

_PAGE = """\
<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Log in to plainspoken</title>
<style>
  :root {{ color-scheme: light dark; font: 100%/1.5 system-ui, sans-serif }}
  body {{ display: grid; place-items: center; min-height: 100vh; margin: 0 }}
  form {{ display: grid; gap: .75rem; width: min(24rem, 90vw) }}
  input, button {{ font: inherit; padding: .6rem; border: 1px solid; border-radius: .4rem }}
  button {{ background: #1d5c38; color: #fff; border-color: #1d5c38; cursor: pointer }}
  :focus-visible {{ outline: 3px solid #2f7fd6; outline-offset: 2px }}
  [role=alert] {{ font-weight: 600 }}
</style>
<main>
  <form method="post" action="{action}">
    <h1>plainspoken</h1>
    {alert}
    <label for="token">Your token</label>
    <input id="token" name="token" type="password" autocomplete="current-password" required
      autofocus>
    <input type="hidden" name="next" value="{next}">
    <button>Log in</button>
    <p>Whoever started the server gives tokens: <code>plainspoken token</code>.</p>
  </form>
</main>
</html>
"""


def login_routes(access: Access, rates: Rates | None = None) -> list[Route]:
    """The form, what it is sent to, and the way out."""
    counted = rates or Rates()

    async def form(request: Request) -> Response:
        goal = local(request.query_params.get("next", "/"))
        return RedirectResponse(goal, 303) if access.is_open else _form(goal)

    async def login(request: Request) -> Response:
        fields = parse_qs((await request.body()).decode("utf-8", "replace"))
        goal = local(fields.get("next", ["/"])[0])
        try:
            found = access.login(fields.get("token", [""])[0].strip())
            if found is None:
                counted.spend(REFUSALS, address_of(request.scope))
                return _form(goal, "There is no such token.", 401)
        except TooManyError as error:
            return _form(goal, f"Too many wrong tokens: {error.hint}.", 429, error.after)
        except PlainspokenError as error:
            return _form(goal, error.what, 503)
        cookie, _ = found
        response = RedirectResponse(goal, 303)
        response.set_cookie(
            COOKIE,
            cookie,
            max_age=access.lasts,
            httponly=True,
            samesite="lax",
            secure=request.url.scheme == "https",
        )
        return response

    async def logout(request: Request) -> Response:
        cookie = login_cookie(request.headers)
        if cookie is not None:
            access.logout(cookie)
        response = RedirectResponse(LOGIN, 303)
        response.delete_cookie(COOKIE, httponly=True, samesite="lax")
        return response

    return [
        Route(LOGIN, form, methods=["GET"]),
        Route(LOGIN, login, methods=["POST"]),
        Route(LOGOUT, logout, methods=["POST"]),
    ]


def local(path: str) -> str:
    """A path of ours to go on to; the first page where it would lead elsewhere."""
    fits = path.startswith("/") and not path.startswith("//") and "\\" not in path
    return path if fits and path.isprintable() else "/"


def _form(
    goal: str, trouble: str | None = None, status: int = 200, after: int | None = None
) -> Response:
    alert = f'<p role="alert">{escape(trouble)}</p>' if trouble else ""
    text = _PAGE.format(action=LOGIN, next=escape(goal), alert=alert)
    headers = {} if after is None else {"Retry-After": str(after)}
    return HTMLResponse(text, status, headers)
