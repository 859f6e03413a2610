"""Printing to PDF by a headless browser."""
import pathlib
import shutil
import subprocess
import tempfile

BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
FLAGS = ("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-sync")


class PrintError(RuntimeError):
    """The browser did not print."""


def find_browser():
    """Path of a browser that can print, or None."""
    return next((found for name in BROWSERS if (found := shutil.which(name))), None)


def print_page(browser, page, target):
    """Prints one HTML file; the target appears whole or not at all."""
    target = pathlib.Path(target).resolve()
    target.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="seiche-browser-") as profile:
        beside = target.with_name(target.name + ".new")
        command = [browser, *FLAGS, f"--user-data-dir={profile}", "--no-pdf-header-footer",
                   f"--print-to-pdf={beside}", pathlib.Path(page).resolve().as_uri()]
        try:
            run = subprocess.run(command, capture_output=True, text=True, timeout=600)
        except subprocess.TimeoutExpired:
            raise PrintError(f"{browser} did not finish printing {page} within 10 minutes") from None
        if run.returncode != 0 or not beside.exists() or beside.stat().st_size == 0:
            raise PrintError(f"{browser} could not print {page}: {run.stderr.strip()[-500:]}")
        beside.replace(target)
