"""Runs unittests, and leaves a JUnit file: unittest_junit.py REPORT [option of `unittest discover`]…"""

import sys
import time
import unittest
from xml.etree import ElementTree


class Result(unittest.TextTestResult):
    """Collects a test case for each test; a subtest that fails counts for its test."""

    suite = ElementTree.Element("testsuite", name="unittest")

    def startTest(self, test):
        super().startTest(test)
        self.began = time.monotonic()
        self.case = ElementTree.SubElement(self.suite, "testcase", name=test.id())

    def stopTest(self, test):
        self.case.set("time", f"{time.monotonic() - self.began:.3f}")
        super().stopTest(test)

    def addError(self, test, err):
        super().addError(test, err)
        self.tell(test, "error")

    def addFailure(self, test, err):
        super().addFailure(test, err)
        self.tell(test, "failure")

    def addSubTest(self, test, subtest, err):
        super().addSubTest(test, subtest, err)
        if err is not None:
            self.tell(test, "failure")

    def addUnexpectedSuccess(self, test):
        super().addUnexpectedSuccess(test)
        self.tell(test, "failure")

    def addSkip(self, test, reason):
        super().addSkip(test, reason)
        self.tell(test, "skipped")

    def tell(self, test, what):
        # The set-up of a class or a module fails outside of any test.
        inside = isinstance(test, unittest.TestCase)
        case = self.case if inside else ElementTree.SubElement(self.suite, "testcase", name=test.id())
        ElementTree.SubElement(case, what)


if __name__ == "__main__":
    report, arguments = sys.argv[1], sys.argv[2:]
    runner = unittest.TextTestRunner(resultclass=Result)
    program = unittest.main(None, argv=["unittest", "discover", *arguments], testRunner=runner, exit=False)
    ElementTree.ElementTree(Result.suite).write(report, encoding="utf-8")
    sys.exit(not program.result.wasSuccessful())
