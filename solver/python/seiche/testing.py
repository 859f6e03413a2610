"""For pytest: a result that must meet the claims of a case.

    from seiche.testing import assert_score
    def test_monai(): assert_score("monai_valley", my_gauges(), dx=0.014)
"""
import pytest

from .scoring import case as _case


def assert_score(case, data, *, baseline=None, parameters=None, **words):
    """Fails with the claims that are not met; with a baseline, a folder, with those that got worse since it was blessed."""
    result = _case(case, **(parameters or {})).score(data, baseline=baseline, **words)
    if result.worse:
        raise AssertionError("\n".join(result.worse))
    bad = [claim for claim in result.claims if claim["verdict"] != "pass"]
    if bad and baseline is None:
        raise AssertionError(f"{result!r}\n" + "\n".join(
            f"{claim['verdict']}: {claim['text']} ({claim['id']}: {claim['measured']}, must be within {claim['limit']} of "
            f"{claim['expected']} {claim['unit']})" for claim in bad))
    return result


@pytest.fixture
def seiche_score(tmp_path):
    """assert_score, with the record in the test's own folder."""
    return lambda case, data, **words: assert_score(case, data, out=tmp_path / "seiche", **words)
