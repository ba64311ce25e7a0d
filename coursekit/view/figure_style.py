"""The colours of figures, on light and dark pages."""

from __future__ import annotations

COLOURS = {
    "ink": ("#4a5862", "#b9c4cd"),
    "rim": ("#d5dde3", "#46535e"),
    "free": ("#ffffff", "#2b353d"),
    "unknown": ("#e3e8ec", "#161c21"),
    "wall": ("#414e58", "#d3dbe1"),
    "own": ("#1f6fc0", "#6bb1f5"),
    "truth": ("#1e8f57", "#62cf95"),
    "guess": ("#d97a10", "#f0a94e"),
    "bad": ("#cf2f24", "#ff7f74"),
    "shelf": ("#98a5af", "#55626d"),
    "missed": ("#f3c4bf", "#6b322d"),
    "robot1": ("#1f6fc0", "#6bb1f5"),
    "robot2": ("#1e8f57", "#62cf95"),
    "robot3": ("#d0447f", "#f58fb9"),
    "robot4": ("#8b53c6", "#c59bf2"),
    "cost1": ("#eef4fb", "#2c3a47"),
    "cost2": ("#d3e3f4", "#2f4860"),
    "cost3": ("#a9c8e8", "#33587b"),
    "cost4": ("#7aa9d6", "#3d6e9a"),
}
"""By kind: the colour on light and on dark pages."""

_RULES = """.ck-drawn{{margin:10px 0 4px;font:12px/1.4 var(--jp-ui-font-family,system-ui,sans-serif)}}
.ck-drawn .drawn-parts{{display:flex;flex-wrap:wrap;gap:6px 14px;padding:1px}}
.ck-drawn .drawn-part{{flex:0 1 auto;min-width:0}}
.ck-drawn .drawn-title{{color:var(--ink);margin:0 0 2px}}
.ck-drawn svg{{display:block;margin:0;max-width:100%;height:auto;border-radius:6px;box-shadow:0 0 0 1px var(--rim)}}
.ck-drawn .line{{fill:none;stroke:var(--k);stroke-width:1.8;stroke-linejoin:round;stroke-linecap:round}}
.ck-drawn .wide{{stroke-width:3}}
.ck-drawn .dashed{{stroke-dasharray:5 4}}
.ck-drawn .fill{{fill:var(--k)}}
.ck-drawn .halo{{fill:none;stroke:var(--free);stroke-width:4}}
.ck-drawn .ring{{fill:none;stroke:var(--bad);stroke-width:2.4}}
.ck-drawn text{{fill:var(--k);font:11px var(--jp-ui-font-family,system-ui,sans-serif)}}
.ck-drawn figcaption{{display:flex;flex-wrap:wrap;gap:2px 16px;margin:5px 0 0;color:var(--ink)}}
.ck-drawn .mover{{display:none;stroke:var(--free);stroke-width:2}}
.ck-drawn:has(input:checked) .mover{{display:inline}}
.ck-drawn .drawn-play{{display:inline-flex;gap:6px;align-items:center;margin:0 0 4px;color:var(--ink);cursor:pointer}}
.ck-drawn .drawn-key i{{display:inline-block;vertical-align:middle;margin-right:6px;background:var(--k)}}
.ck-drawn .drawn-key .stroke{{width:18px;height:3px;border-radius:2px}}
.ck-drawn .drawn-key .dash{{width:18px;height:3px;background:repeating-linear-gradient(90deg,var(--k) 0 6px,#0000 6px 10px)}}
.ck-drawn .drawn-key .dot{{width:8px;height:8px;border-radius:50%}}
.ck-drawn .drawn-key .cell{{width:12px;height:12px;border:1px solid var(--rim)}}
.ck-drawn .drawn-key .round{{width:9px;height:9px;border:2.4px solid var(--bad);border-radius:50%;background:none}}"""


def style() -> str:
    """Return the CSS rules of a figure's colours, for the theme of JupyterLab or a course page, else the system's.

    >>> "--own:#1f6fc0" in style() and "prefers-color-scheme:dark" in style()
    True
    """
    light, dark = (";".join(f"--{kind}:{both[at]}" for kind, both in COLOURS.items()) for at in (0, 1))
    kinds = "".join(f".ck-drawn .{kind}{{--k:var(--{kind})}}" for kind in COLOURS)
    rules = _RULES.format().replace("\n", "")
    named = f'[data-jp-theme-light="false"] .ck-drawn,[data-theme="dark"] .ck-drawn{{{dark}}}'
    unnamed = 'body:not([data-jp-theme-light],[data-theme="light"]) .ck-drawn'
    others = f"@media(prefers-color-scheme:dark){{{unnamed}{{{dark}}}}}"
    return f".ck-drawn{{{light}}}{named}{others}{kinds}{rules}"


__all__ = ["COLOURS", "style"]
