"""The renderer on a folder that a stranger prepared: nothing outside it is read, and no record stops the report.

    /usr/bin/python3 reports/render/tests/test_strangers.py
"""
import hashlib
import json
import os
import pathlib
import tempfile
import time
import unittest
import unittest.mock

import h5py
from made import figure, record, render

SECRET = "of nobody's business"


class Strangers(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.evidence, self.out = self.folder / "evidence", self.folder / "report"
        self.evidence.mkdir()
        self.secret = self.folder / "secret"
        self.secret.write_text(SECRET)
        self.write("honest", record("honest"))

    def write(self, name, raw):
        (self.evidence / f"{name}.json").write_text(json.dumps(raw))

    def with_data(self, name, fill):
        """A record with one figure, whose HDF5 file `fill` writes."""
        self.write(name, record(name, data=f"{name}.h5", figures=[figure("f")]))
        with h5py.File(self.evidence / f"{name}.h5", "w") as file:
            fill(file)

    def report(self):
        """Index and provenance of the report; the honest record is in it, the secret nowhere."""
        started = time.monotonic()
        status, said = render(self.evidence, self.out, "--jobs", "1", "--with-data")
        self.assertEqual(status, 0, said)
        self.assertLess(time.monotonic() - started, 60)
        self.assertTrue((self.out / "cases/honest.html").is_file())
        for path in self.out.rglob("*"):
            self.assertFalse(path.is_symlink(), path)
            if path.is_file():
                self.assertNotIn(SECRET.encode(), path.read_bytes(), path)
        return "".join((self.out / name).read_text(encoding="utf-8") for name in ("index.html", "provenance.html"))

    def test_links_and_pipes_are_not_followed(self):
        (self.evidence / "junit.xml").symlink_to(self.secret)
        (self.evidence / "linked.json").symlink_to(self.secret)
        os.mkfifo(self.evidence / "pipe.json")
        self.write("fields", record("fields", data="data.h5", fields="fields.xdmf", figures=[figure("f")]))
        (self.evidence / "data.h5").symlink_to(self.secret)
        (self.evidence / "fields.xdmf").symlink_to(self.secret)
        page = self.report()
        for name in ("linked.json", "pipe.json", "data.h5", "fields.xdmf"):
            self.assertIn(name, page)
        self.assertIn("links and pipes are not followed", page)

    def test_a_prepared_report_gives_nothing_to_the_next(self):
        self.report()
        texts = self.out / ".cache" / "texts.json"
        texts.parent.mkdir()
        texts.write_text("{}")
        (self.out / "data" / "honest.json").write_text(SECRET)
        self.report()
        self.assertFalse(texts.exists())

    def test_data_in_other_files_are_refused(self):
        def link(file):
            file["figures/f"] = h5py.ExternalLink(str(self.secret), "/")

        def storage(file):
            file.create_dataset("figures/f/panel_0/series_0/x", shape=(8,), dtype="u1",
                                external=[(str(self.secret), 0, 8)])

        def soft(file):
            file["figures/f"] = h5py.SoftLink("/figures")

        def loop(file):
            inner = file.create_group("figures/f")
            inner["up"] = file["figures"]

        def elsewhere(file):
            layout = h5py.VirtualLayout(shape=(8,), dtype="f8")
            layout[:] = h5py.VirtualSource(str(self.secret), "x", shape=(8,))
            file.create_virtual_dataset("figures/f/panel_0/series_0/x", layout)

        for fill in (link, storage, soft, loop, elsewhere):
            self.with_data(fill.__name__, fill)
        page = self.report()
        for name in ("link", "storage", "soft", "loop", "elsewhere"):
            self.assertIn(f"{name}.h5 cannot be read: ", page)

    def test_what_only_claims_to_be_large_is_not_allocated(self):
        def large(file):
            file.create_dataset("figures/f/panel_0/series_0/x", shape=(2 * 10**9,), dtype="f8", chunks=(2**20,))
        self.with_data("large", large)
        self.assertLess((self.evidence / "large.h5").stat().st_size, 10**6)
        self.assertIn("2000000000 numbers", self.report())

    def test_what_was_changed_after_it_was_written_is_said(self):
        def sealed(raw):
            text = json.dumps(raw, indent=1)[:-2] + ',\n "digest": "'
            return text + hashlib.sha256(text.encode()).hexdigest() + '"\n}\n'

        fields = {name: hashlib.sha256(b"as written").hexdigest() for name in ("fields.xdmf", "exchanged.xdmf")}
        for name in ("whole", "edited", "fields", "exchanged"):
            text = sealed(record(name, fields=f"{name}.xdmf" if f"{name}.xdmf" in fields else "", files=fields))
            (self.evidence / f"{name}.json").write_text(text.replace("3.8412e-15", "0.5") if name == "edited" else text)
        (self.evidence / "fields.xdmf").write_bytes(b"as written")
        (self.evidence / "exchanged.xdmf").write_bytes(b"of another run")
        page = self.report()
        self.assertRegex(page, r"edited.json[\s\S]{0,200}changed after it was written")
        self.assertIn("exchanged.xdmf is not the file that was written with the record", page)
        for name in ("fields.xdmf", "whole.json"):
            self.assertNotIn(f"{name} is not", page)
        self.assertRegex(page, r"honest[\s\S]{0,200}carries no digest")
        self.assertEqual(page.count("carries no digest"), 1)

    def test_texts_that_no_person_wrote(self):
        self.write("brackets", record("brackets", article="[" * 30000))
        self.write("ticks", record("ticks", article=" ".join("`" * n for n in range(1, 300))))
        self.write("surrogate", record("surrogate", article="half a pair: \ud800"))
        (self.evidence / "deep.json").write_text("[" * 200000)
        with unittest.mock.patch("render.text.LONGEST", 0.5):
            page = self.report()
        for name in ("surrogate.json", "deep.json"):
            self.assertIn(name, page)
        self.assertNotIn("page not made", page)
        for name in ("brackets", "ticks"):
            self.assertTrue((self.out / f"cases/{name}.html").is_file())


if __name__ == "__main__":
    unittest.main()
