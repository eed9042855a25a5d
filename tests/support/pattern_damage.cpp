// Texts of crease patterns in every format, and ways to damage them: for fuzzing their readers.
// SPDX-License-Identifier: MIT
#include "tests/support/pattern_damage.h"

#include <algorithm>

namespace kiri::test {

namespace {

const char* const kFoldFlat = R"({"file_spec":1.2,"file_creator":"x","file_title":"t",
"file_author":"a","file_classes":["singleModel"],"frame_classes":["creasePattern"],
"frame_unit":"mm","frame_attributes":["2D"],
"vertices_coords":[[0,0],[2,0],[2,2],[0,2],[1,1],[1,0]],
"edges_vertices":[[0,5],[5,1],[1,2],[2,3],[3,0],[0,4],[1,4],[2,4],[3,4],[5,4]],
"edges_assignment":["B","B","B","B","B","M","V","M","U","C"],
"edges_foldAngle":[0,0,0,0,0,-180,90.5,-1e-3,null,0],
"edges_faces":[[0,null],[4,null],[1],[2,null],[3,null],[3,0],[4,1],[1,2],[2,3],[0,4]],
"faces_vertices":[[0,5,4],[1,2,4],[2,3,4],[3,0,4],[5,1,4]],
"faceOrders":[[0,1,1],[1,2,-1],[2,3,0]],"other:key":{"a":[1,2]},"edges_my:x":[1]})";

const char* const kFoldFrames = R"({"file_spec":1,"frame_classes":["foldedForm"],
"vertices_coords":[[0,0,0],[1,0,0],[1,1,0],[0.5,0.5,0.70710678]],
"edges_vertices":[[0,1],[1,2],[2,3],[3,0],[0,2]],"edges_assignment":["B","B","B","B","V"],
"edges_foldAngles":[0,0,0,0,90],"faces_vertices":[[0,1,2],[0,2,3]],
"file_frames":[{"frame_parent":0,"frame_inherit":true,"faceOrders":[[0,1,1]]},
{"frame_parent":1,"frame_inherit":true,"vertices_coords":[[0,0],[1,0],[1,1],[1,0]]}]})";

const char* const kFoldForm = R"({"frame_classes":["foldedForm"],
"vertices_coords":[[0,0],[1,0],[1,1],[1,0],[0,1],[2,2]],
"faces_vertices":[[0,1,2],[0,2,3],[3,2,4],[4,5,2]]})";

const char* const kCp =
    "1 -200 -200 200 -200\n1 200 -200 200 200\n1 200 200 -200 200\n1 -200 200 -200 -200\n"
    "2 -200 -200 0 0\n3 0 0 200 200\n4 -200 200 1.5e-3 -0.0\n0 0 0 200 -200\n";

const char* const kOpxBean = R"(<?xml version="1.0" encoding="UTF-8"?>
<java version="1.5.0_02" class="java.beans.XMLDecoder"><object class="oripa.DataSet">
<void property="lines"><array class="oripa.OriLineProxy" length="3">
<void index="0"><object class="oripa.OriLineProxy"><void property="type"><int>1</int></void>
<void property="x0"><double>200.0</double></void><void property="x1"><double>-200.0</double></void>
<void property="y0"><double>200.0</double></void><void property="y1"><double>200.0</double></void>
</object></void><void index="1"><object class="oripa.OriLineProxy">
<void property="x0"><double>-200.0</double></void><void property="x1"><double>-2E2</double></void>
<void property="y1"><double>200.0</double></void></object></void>
<void index="2"><object class="oripa.OriLineProxy"><void property="type"><int>2</int></void>
<void property="x0"><double>-200.0</double></void><void property="y1"><double>2.0</double></void>
</object></void></array></void><void property="title"><string>t &amp; u</string></void>
</object></java>)";

const char* const kOpxFields = R"(<java version="1.8.0_333" class="java.beans.XMLDecoder">
<object class="oripa.DataSet" id="DataSet0"><void class="oripa.DataSet" method="getField">
<string>lines</string><void method="set"><object idref="DataSet0"/>
<array class="oripa.OriLineProxy" length="1"><void index="0">
<object class="oripa.OriLineProxy"><void property="type"><int>3</int></void>
<void property="x0"><double>1</double></void></object></void></array></void></void>
<void class="oripa.DataSet" method="getField"><string>memo</string><void method="set">
<object idref="DataSet0"/><string>m</string></void></void></object></java>)";

const char* const kSvgLines = R"x(<?xml version="1.0"?><svg xmlns="http://www.w3.org/2000/svg"
 xmlns:xlink="http://www.w3.org/1999/xlink" width="10cm" height="10cm" viewBox="0 0 100 100">
<title>t</title><style>.m{stroke:#f00;opacity:.5} line{stroke-width:2}</style>
<g transform="translate(5 5) rotate(30,50,50) scale(1.5,-1) skewX(10) matrix(1 0 0 1 2 3)">
<line x1="0" y1="0" x2="1e1" y2="10" class="m"/><rect x="0" y="0" width="90" height="90"
 stroke="black" fill="none"/><polyline points="0,0 10,5 20,0" style="stroke:blue"/>
<polygon points="1 1 2 2 3 1" stroke="rgb(0,255,0)"/></g></svg>)x";

const char* const kSvgCurves = R"x(<svg viewBox="0 0 9 9"><defs><symbol id="s" viewBox="0 0 4 4">
<path d="M0 0L4 4" stroke="red"/></symbol><g id="g"><use href="#s" x="1"/></g></defs>
<path d="M0,0 c1 2 3 4 5 6 s1-1 2 0 q1 1 2 0 t3 3 a5 3 20 1 0 4 4 h5 v-5 l1 1 zm1 1H3V4L0 0Z"
 stroke="#00f" stroke-opacity="50%"/><circle cx="3" cy="3" r="2" stroke="#000"/>
<ellipse cx="3" cy="3" rx="2" ry="1" stroke="magenta"/><use xlink:href="#g" y="2"/>
<line x1="1" y1="2" x2="3" y2="4" data-assignment="M" data-foldAngle="-90"/></svg>)x";

const char* const kDxfLines =
    "  0\nSECTION\n  2\nHEADER\n  9\n$INSUNITS\n 70\n4\n  0\nENDSEC\n  0\nSECTION\n  2\nTABLES\n"
    "  0\nTABLE\n  2\nLAYER\n  0\nLAYER\n  2\nA\n 62\n1\n  0\nENDTAB\n  0\nENDSEC\n  0\nSECTION\n"
    "  2\nENTITIES\n  0\nLINE\n  8\nCutLine\n 10\n0\n 20\n0\n 11\n5\n 21\n0\n  0\nLINE\n  8\nA\n"
    " 10\n0.5\n 20\n0\n 11\n5\n 21\n1e1\n  0\nLWPOLYLINE\n  8\nCutLine\n 90\n3\n 70\n1\n 10\n0\n"
    " 20\n0\n 42\n0.5\n 10\n9\n 20\n0\n 10\n9\n 20\n9\n  0\nENDSEC\n  0\nEOF\n";

const char* const kDxfBlocks =
    "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nB\n10\n1\n20\n0\n0\nLINE\n8\n0\n11\n5\n0\nINSERT\n2\nC\n0"
    "\n"
    "ENDBLK\n0\nBLOCK\n2\nC\n0\nARC\n10\n1\n20\n2\n40\n3\n50\n10\n51\n300\n0\nENDBLK\n0\nENDSEC\n0"
    "\n"
    "SECTION\n2\nENTITIES\n0\nINSERT\n2\nB\n8\nValleyLine\n41\n2\n50\n30\n70\n3\n44\n7\n0\nSPLINE\n"
    "71\n3\n40\n0\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n40\n1\n10\n0\n20\n0\n10\n0\n20\n4\n10"
    "\n4\n"
    "20\n4\n10\n4\n20\n0\n0\nPOLYLINE\n70\n1\n0\nVERTEX\n10\n1\n20\n1\n42\n-"
    "1\n0\nVERTEX\n10\n4\n20\n2\n"
    "0\nSEQEND\n0\nELLIPSE\n10\n1\n20\n1\n11\n4\n21\n0\n40\n0.5\n41\n0\n42\n6."
    "28\n0\nCIRCLE\n10\n1\n"
    "20\n1\n40\n5\n0\nENDSEC\n0\nEOF\n";

const std::vector<std::string>& numberTokens() {
  static const std::vector<std::string> kTokens = {
      "0",     "-1",  "1e308",     "-1e308", "1e-308",       "1e999", "99999999999", "4294967296",
      "1e12",  "0.5", "nan",       "inf",    "-0",           "1e",    "--",          "0x1p3",
      "1e-13", "3",   "180.00001", "\xff",   "\xEF\xBB\xBF", "\n",    " ",           "\t"};
  return kTokens;
}

std::vector<std::string> withNumbers(std::vector<std::string> tokens) {
  tokens.insert(tokens.end(), numberTokens().begin(), numberTokens().end());
  return tokens;
}

bool isPartOfNumber(char c) {
  return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e';
}

/// Exchanges the number at or after a place for a token or for another number of the text.
void changeNumber(std::string& text, std::size_t at, DamageSource& source) {
  while (at < text.size() && !(text[at] >= '0' && text[at] <= '9')) ++at;
  std::size_t end = at;
  while (end < text.size() && isPartOfNumber(text[end])) ++end;
  while (at > 0 && isPartOfNumber(text[at - 1])) --at;
  const std::vector<std::string>& tokens = numberTokens();
  text.replace(at, end - at, tokens[source.below(tokens.size())]);
}

}  // namespace

const std::array<PatternSeeds, 5>& patternSeeds() {
  static const std::array<PatternSeeds, 5> kSeeds = {
      {{"f.fold",
        {kFoldFlat, kFoldFrames, kFoldForm},
        withNumbers({"{",
                     "}",
                     "[",
                     "]",
                     ",",
                     ":",
                     "null",
                     "true",
                     "[]",
                     "{}",
                     "[0,0]",
                     "[0,1,1]",
                     "\"B\"",
                     "\"M\"",
                     "\"x\"",
                     "\"frame_inherit\":true,",
                     "\"frame_parent\":1,",
                     "\"foldedForm\"",
                     "\"creasePattern\"",
                     "\"faces_vertices\":"})},
       {"f.cp", {kCp}, withNumbers({"1 0 0 1 1\n", "2 -1 5 5 5\n", "7", ",", "#"})},
       {"f.opx",
        {kOpxBean, kOpxFields},
        withNumbers({"<", ">", "/>", "</void>", "<void>", "<object class=\"oripa.OriLineProxy\">",
                     "property=\"x0\"", "<double>", "&lt;", "&#0;", "&x;", "<![CDATA[", "<!--",
                     "<!DOCTYPE a [<!ENTITY x \"y\">]>", "\"", "<string>"})},
       {"f.svg",
        {kSvgLines, kSvgCurves},
        withNumbers({"<",
                     ">",
                     "/>",
                     "</g>",
                     "<g>",
                     "M",
                     "z",
                     "c",
                     "a",
                     "1 1 0 0 1 5 5",
                     "%",
                     "mm",
                     "rotate(",
                     "scale(0)",
                     "matrix(1,2,2,4,0,0)",
                     "url(#s)",
                     "currentColor",
                     "href=\"#g\"",
                     "id=\"g\"",
                     "stroke=\"red\"",
                     "<use href=\"#g\"/>",
                     "px",
                     "viewBox=\"0 0 0 0\"",
                     "{",
                     "}",
                     ";",
                     "/*",
                     "rgb(",
                     "none"})},
       {"f.dxf",
        {kDxfLines, kDxfBlocks},
        withNumbers({"0\nLINE\n", "0\nENDSEC\n", "0\nSECTION\n2\nENTITIES\n", "0\nINSERT\n2\nB\n",
                     "70\n9999\n", "10\n1\n20\n1\n", "42\n1e9\n", "0\nENDBLK\n", "0\nBLOCK\n2\nB\n",
                     "0\nVERTEX\n", "0\nEOF\n", "230\n-1\n", "71\n7\n", "999\nx\n", "41\n0\n"})}}};
  return kSeeds;
}

void damage(std::string& text, const std::vector<std::string>& tokens, DamageSource& source) {
  if (text.empty()) text = "0";
  const std::size_t at = source.below(text.size());
  const std::size_t length = 1 + source.below(24);
  const std::string& token = tokens[source.below(tokens.size())];
  switch (source.below(8)) {
    case 0:
      text[at] = static_cast<char>(source.below(256));
      break;
    case 1:
      text.erase(at, length);
      break;
    case 2:
      text.insert(at, text.substr(at, length * 4));
      break;
    case 3:
      text.replace(at, length, token);
      break;
    case 4:
      text.insert(at, token);
      break;
    case 5: {
      const std::string part = text.substr(at, length);
      text.erase(at, length);
      text.insert(std::min(text.size(), source.below(text.size() + 1)), part);
      break;
    }
    default:
      changeNumber(text, at, source);
      break;
  }
}

}  // namespace kiri::test
