"""links.py folder: every link of the site leads to a file of it and to a heading of that page. Says which do not; exit status 1 then."""
import html.parser
import os
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.links, self.names = [], set()
        with open(path, encoding="utf-8") as file:
            self.feed(file.read())

    def handle_starttag(self, tag, attributes):
        for key, value in attributes:
            if key == "id" or (tag == "a" and key == "name"):
                self.names.add(value)
            if key in ("href", "src") and tag in ("a", "img") and value:
                self.links.append(value)


root = os.path.abspath(sys.argv[1])
paths = [os.path.join(folder, name) for folder, _, names in os.walk(root) for name in names if name.endswith(".html")]
pages = {path: Page(path) for path in paths if os.path.basename(path) != "404.html"}
broken = count = 0
for path, page in sorted(pages.items()):
    for link in page.links:
        parts = urllib.parse.urlsplit(link)
        if parts.scheme or parts.netloc:
            continue
        count += 1
        target = os.path.normpath(os.path.join(os.path.dirname(path), urllib.parse.unquote(parts.path))) if parts.path else path
        if os.path.isdir(target):
            target = os.path.join(target, "index.html")
        good = os.path.isfile(target)
        if good and parts.fragment and target in pages:
            good = urllib.parse.unquote(parts.fragment) in pages[target].names or parts.fragment.startswith("__")
        if not good:
            broken += 1
            print(f"{os.path.relpath(path, root)}: {link} leads nowhere")
print(f"{count} links, {broken} broken")
sys.exit(broken > 0)
