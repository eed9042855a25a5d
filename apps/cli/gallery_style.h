// How the gallery's pages look.
// SPDX-License-Identifier: MIT
#pragma once

namespace kiri::cli {

/// A style sheet, for <style>. Pictures keep their white ground in the dark: paper has colours.
inline constexpr const char* kGalleryStyle = R"(
:root { color-scheme: light dark; --ink: #222; --soft: #5a5a5a; --ground: #fff; --line: #ddd;
  --link: #1f661f }
@media screen and (prefers-color-scheme: dark) { :root { --ink: #e6e6e0; --soft: #b0b0a8;
  --ground: #1b1c1a; --line: #3c3d3a; --link: #8fd08f } }
* { box-sizing: border-box }
body { font: 1rem/1.5 system-ui, sans-serif; margin: 0 auto; max-width: 76rem; padding: 1.5rem 1rem;
  color: var(--ink); background: var(--ground); overflow-wrap: break-word }
h1, h2 { font-weight: 600; line-height: 1.2; text-wrap: balance }
h2 { margin: 2.2rem 0 .4rem }
a { color: var(--link) }
a:focus-visible, video:focus-visible { outline: 3px solid var(--link); outline-offset: 2px }
img, video { display: block; width: 100%; height: auto; background: #fff; border-radius: 6px;
  border: 1px solid var(--line) }
.notes { color: var(--soft); max-width: 46rem }
.plain { list-style: none; margin: 0; padding: 0 }
.bar { display: flex; flex-wrap: wrap; gap: .3rem 1.5rem }
main + nav { margin-top: 2.5rem }
.models, .pictures { display: grid; gap: 1.5rem;
  grid-template-columns: repeat(auto-fill, minmax(min(20rem, 100%), 1fr)) }
.models { gap: 1.2rem 1rem; grid-template-columns: repeat(2, minmax(0, 1fr)) }
@media (min-width: 36rem) { .models { gap: 1.5rem;
  grid-template-columns: repeat(auto-fill, minmax(13rem, 1fr)) } }
.models a { display: block; font-weight: 600; line-height: 1.3 }
.models img { margin-bottom: .4rem }
.models .notes { margin: .2rem 0 0; font-size: .9em; line-height: 1.4 }
figure { margin: 0 }
figcaption { margin-top: .3rem; color: var(--soft) }
.sheet { overflow-x: auto; margin-top: 1.5rem; padding: 3px }
.sheet img { min-width: 40rem; max-width: 60rem }
.leaf { display: flex; flex-wrap: wrap; gap: 1.5rem; align-items: flex-start; margin-top: 1rem }
.leaf figure { flex: 1 1 20rem; max-width: 34rem }
.steps { columns: 2 22rem; column-gap: 3rem; padding-left: 1.8rem }
.steps li { margin: 0 0 .6rem; padding-left: .2rem; break-inside: avoid } .steps p { margin: 0 }
table { border-collapse: collapse; max-width: 24rem }
caption { text-align: left; color: var(--soft); padding-bottom: .3rem }
th, td { text-align: left; font-weight: normal; padding: .15rem .9rem .15rem 0;
  border-bottom: 1px solid var(--line) }
td { padding-right: 0; text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums }
footer { margin-top: 3rem; color: var(--soft) }
@media print { body { max-width: none; padding: 0; font-size: 10pt } nav, .film { display: none }
  a { color: inherit; text-decoration: none } img { border: 0 } h2 { break-after: avoid }
  figure, .models li, table { break-inside: avoid } .sheet { overflow: visible }
  .sheet img { min-width: 0; max-width: 100% } .steps { columns: 2 } .leaf { display: block }
  .models { grid-template-columns: repeat(5, 1fr) }
  .pictures { grid-template-columns: repeat(3, 1fr) } }
)";

}  // namespace kiri::cli
