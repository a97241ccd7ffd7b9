// The search of the manual, in manual_index.js, by parts of names; and the mark in the navigation for the section that is
// being read. Everything else on the pages works without scripts.
"use strict";

(function () {
  const place = document.getElementById("amf-search");
  if (!place || typeof manualIndex === "undefined") return;

  const query = document.createElement("input");
  Object.assign(query, { type: "search", id: "amf-query", placeholder: "Search", autocomplete: "off", spellcheck: false });
  query.setAttribute("aria-label", "Search the manual");
  const results = document.createElement("div");
  results.id = "amf-results";
  results.hidden = true;
  place.append(query, results);
  let chosen = -1;

  // The lower the better: the whole name, its beginning, the beginning of a word in it, anywhere; infinite for no match.
  function rank(words, name, scope) {
    let sum = 0;
    for (const word of words) {
      const at = name.indexOf(word);
      if (at === 0) sum += name === word || name === word + "()" ? 0 : 1;
      else if (at > 0) sum += /[\s_]/.test(name[at - 1]) ? 2 : 3;
      else if (scope.includes(word)) sum += 4;
      else return Infinity;
    }
    return sum;
  }

  const kindRank = { concept: 0, class: 0, struct: 0, module: 0, page: 0, section: 1, function: 1, typedef: 2 };

  function find(text) {
    const words = text.toLowerCase().split(/[\s:]+/).filter(Boolean);
    if (!words.length) return [];
    return manualIndex
      .map((row) => [rank(words, row[0].toLowerCase(), row[1].toLowerCase()), kindRank[row[2]] ?? 3, row])
      .filter((each) => each[0] < Infinity)
      .sort((a, b) => a[0] - b[0] || a[1] - b[1] || a[2][0].length - b[2][0].length)
      .slice(0, 30)
      .map((each) => each[2]);
  }

  function choose(index) {
    const links = results.querySelectorAll("a");
    if (!links.length) return;
    chosen = (index + links.length) % links.length;
    links.forEach((link, i) => link.classList.toggle("amf-chosen", i === chosen));
    links[chosen].scrollIntoView({ block: "nearest" });
  }

  function show() {
    const text = query.value.trim();
    results.hidden = !text;
    results.textContent = "";
    chosen = -1;
    if (!text) return;
    const rows = find(text);
    for (const [name, scope, kind, address] of rows) {
      const link = document.createElement("a");
      link.href = address;
      const title = document.createElement("b");
      title.textContent = name;
      const where = document.createElement("small");
      where.textContent = scope ? kind + " – " + scope : kind;
      link.append(title, where);
      results.append(link);
    }
    if (rows.length) {
      choose(0);
    } else {
      const nothing = document.createElement("p");
      nothing.textContent = "Nothing found.";
      results.append(nothing);
    }
  }

  query.addEventListener("input", show);
  query.addEventListener("focus", show);
  query.addEventListener("keydown", (event) => {
    if (event.key === "ArrowDown") choose(chosen + 1);
    else if (event.key === "ArrowUp") choose(chosen - 1);
    else if (event.key === "Enter" && chosen >= 0) results.querySelectorAll("a")[chosen].click();
    else if (event.key === "Escape") { query.value = ""; show(); query.blur(); }
    else return;
    event.preventDefault();
  });
  document.addEventListener("click", (event) => {
    if (!place.contains(event.target) || event.target.closest("#amf-results a")) results.hidden = true;
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "/" && !/^(INPUT|TEXTAREA)$/.test(document.activeElement.tagName)) {
      query.focus();
      event.preventDefault();
    }
  });
})();

(function () {
  const page = location.pathname.split("/").pop() || "index.html";
  const sections = [];
  for (const link of document.querySelectorAll("#amf-nav a")) {
    const [file, anchor] = link.getAttribute("href").split("#");
    const place = file === page && anchor && document.getElementById(anchor);
    if (place) sections.push([place, link]);
  }
  let current = null;

  function mark() {
    let found = null;
    for (const [place, link] of sections) {
      if (place.getBoundingClientRect().top > 140) break;
      found = link;
    }
    if (found === current) return;
    if (current) current.removeAttribute("aria-current");
    if (found) {
      found.setAttribute("aria-current", "location");
      const nav = document.getElementById("amf-nav");
      const y = found.getBoundingClientRect().top - nav.getBoundingClientRect().top;
      if (y < 0 || y > nav.clientHeight - 40) nav.scrollTop += y - nav.clientHeight / 2;
    }
    current = found;
  }

  // Only those of a text are in the order of the page.
  if (page === "index.html" && sections.length) {
    addEventListener("scroll", mark, { passive: true });
    mark();
  }
})();
