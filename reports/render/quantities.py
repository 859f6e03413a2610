"""Numbers and units as a publication sets them: 3.8 × 10⁻¹⁵, upright units, the full value on hover.

Everything returned is `Markup`, safe to place in a page.
"""
import math
import re

from markupsafe import Markup, escape

MINUS = "\u2212"
THIN = "\u2009"


def _exponent(value):
    return math.floor(math.log10(abs(value))) if value else 0


def _fixed(value, decimals):
    return f"{value:.{max(0, decimals)}f}".replace("-", MINUS)


def _power(exponent):
    return f"10<sup>{str(exponent).replace('-', MINUS)}</sup>"


def plain(value, digits=4):
    """HTML of a finite number with `digits` significant digits, without the wrapping element."""
    if value == 0:
        return "0"
    if float(value).is_integer() and abs(value) < 10**digits:
        return _fixed(value, 0)
    rounded = float(f"{value:.{digits - 1}e}")
    exponent = _exponent(rounded)
    if -4 < exponent < 5:
        text = _fixed(rounded, digits - 1 - exponent)
        return text.rstrip("0").rstrip(".") if "." in text else text
    mantissa = _fixed(rounded / 10.0**exponent, digits - 1).rstrip("0").rstrip(".")
    return _power(exponent) if mantissa == "1" else f"{mantissa}{THIN}×{THIN}{_power(exponent)}"


def number(value, digits=4):
    """A number for a table: at most `digits` significant digits, the full value as title, a dash for null."""
    if value is None or (isinstance(value, float) and not math.isfinite(value)):
        return Markup('<span class="n none" title="not a finite number">—</span>')
    return Markup(f'<span class="n" title="{escape(repr(value))}">{plain(value, digits)}</span>')


def value(anything):
    """A parameter or table entry of any JSON type."""
    if isinstance(anything, bool):
        return Markup("yes" if anything else "no")
    if isinstance(anything, int) and abs(anything) < 10**9:
        grouped = f"{anything:,}" if abs(anything) >= 10**4 else str(anything)
        return Markup(f'<span class="n">{grouped.replace(",", THIN).replace("-", MINUS)}</span>')
    if anything is None or isinstance(anything, (int, float)):
        return number(anything)
    return escape(anything)


def with_uncertainty(measured, uncertainty):
    """measured ± uncertainty with a common power of ten, to two digits of the uncertainty; to one where that is 3 or
    more and the measured value has four digits without the other."""
    if measured is None or uncertainty is None or uncertainty <= 0 or not math.isfinite(uncertainty):
        return number(measured)
    title = escape(f"{measured!r} ± {uncertainty!r}")
    exponent = _exponent(max(abs(measured), uncertainty))
    scaled = exponent if not -4 < exponent < 5 else 0
    a, u = measured / 10.0**scaled, uncertainty / 10.0**scaled
    decimals = 1 - _exponent(float(f"{u:.1e}"))
    if decimals > 3 - _exponent(a if a else u) and f"{u:.1e}" >= "3":     # a 1 or 2 alone is up to a third off
        decimals = -_exponent(float(f"{u:.0e}"))
    if decimals > 6:
        return Markup(f'<span class="n" title="{title}">{plain(measured)}{THIN}±{THIN}{plain(uncertainty, 2)}</span>')
    pair = f"{_fixed(a, decimals)}{THIN}±{THIN}{_fixed(u, decimals)}"
    if scaled:
        pair = f"({pair}){THIN}×{THIN}{_power(scaled)}"
    return Markup(f'<span class="n" title="{title}">{pair}</span>')


def unit(text):
    """Upright unit with raised exponents; nothing for the dimensionless 1."""
    if text in ("", "1", "-"):
        return Markup("")
    html = str(escape(text))
    html = re.sub(r"\^[{(]?(-?\d+(?:[./]\d+)?)[})]?", lambda m: f"<sup>{m[1].replace('-', MINUS)}</sup>", html)
    html = re.sub(r"(?<=\w)\s*[*·]\s*(?=\w)", f"{THIN}", html)
    return Markup(f'<span class="unit">{html}</span>')


def duration(seconds):
    """1.24 s, 4 min 12 s, 2 h 05 min; 0 of a run of others that does not say."""
    if seconds is None:
        return "—"
    if seconds == 0:
        return "not stated"
    if seconds < 0.001:
        return "< 1 ms"
    if seconds < 0.9995:
        return f"{seconds * 1000:.0f} ms"
    if seconds < 59.95:
        return f"{seconds:.3g} s" if seconds < 9.995 else f"{seconds:.1f} s"
    whole = round(seconds)
    if whole < 3600:
        return f"{whole // 60} min {whole % 60:02d} s"
    return f"{whole // 3600} h {whole % 3600 // 60:02d} min"
