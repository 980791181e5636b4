"""Headless Chromium and the explorer's page."""

import pytest
from browser.page import FLAGS, Watch, browser_path, ready, serving


@pytest.fixture(scope="session")
def chromium():
    path = browser_path()
    if path is None:
        pytest.skip("needs Chromium, for instance Debian's package chromium")
    from playwright.sync_api import sync_playwright

    with sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=path, args=list(FLAGS))
        yield browser
        browser.close()


@pytest.fixture(scope="session")
def server():
    with serving() as found:
        yield found


@pytest.fixture
def context(chromium):
    found = chromium.new_context(viewport={"width": 1400, "height": 900}, accept_downloads=True)
    yield found
    found.close()


@pytest.fixture
def page(context, server):
    """The page; no error in its console, and no request that leaves the machine."""
    found = context.new_page()
    watch = Watch(found)
    found.goto(server.url)
    ready(found)
    yield found
    assert watch.errors == []
    assert watch.outside == []
