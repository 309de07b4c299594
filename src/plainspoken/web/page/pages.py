"""The addresses of the page."""
from nicegui import ui


def open_pages(desk, visitor_of, setting) -> None:
    """Register every page."""

    @ui.page("/")
    def home() -> None:
        ui.label("What should be done?")
