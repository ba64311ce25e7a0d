"""The colours of the pages about a class, for light and dark screens."""

STYLE = """:root{color-scheme:light dark;--ink:#1f2a30;--paper:#fff;--soft:#5c686f;--line:#e3e8ea;--code:#f5f7f8;
--link:#1b6271;--right:#1a7f4b;--wrong:#b3392f;--all:#e3f2e9;--some:#fbf3dc}
@media(prefers-color-scheme:dark){:root{--ink:#e3e8ea;--paper:#171c1f;--soft:#a3afb5;--line:#343d42;--code:#222a2e;
--link:#7cc4d3;--right:#63c794;--wrong:#ef8a80;--all:#1d3a2b;--some:#40361a}}
@media(prefers-color-scheme:dark){img.drawn{filter:invert(.9) hue-rotate(180deg)}}
body{background:var(--paper);color:var(--ink)} a{color:var(--link)} img{background:#fff}"""
