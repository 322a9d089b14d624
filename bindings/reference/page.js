"use strict";
(() => {
  const field = document.getElementById("search"), found = document.getElementById("found");
  const all = (query, of = document) => [...of.querySelectorAll(query)];
  const contents = document.querySelector(".contents");
  const entries = all(".entry").map((element) => {
    const items = all("[data-item]", element);
    return { element, items, names: [element.dataset.names, ...items.map((item) => item.id)].map(plain) };
  });
  const links = all("nav li a").map((element) => ({ element, name: plain(element.textContent),
    target: document.getElementById(element.hash.slice(1)) }));
  const wide = matchMedia("(min-width: 60rem)");

  function plain(text) {
    return text.toLowerCase().replace(/[_.]/g, " ");
  }

  // An entry is shown if one of its names has all words that are looked for, of tables only those rows unless the whole
  // is meant; where no name has them, if its text has.
  function filter() {
    const words = plain(field.value).split(/\s+/).filter(Boolean), asked = words.length > 0;
    const has = (text) => words.every((word) => text.includes(word));
    const inNames = entries.some((entry) => entry.names.some(has));
    let count = 0;
    for (const { element, items, names } of entries) {
      const shown = !asked || (inNames ? names.some(has) : has(plain(element.textContent)));
      element.hidden = !shown;
      const hits = new Set(asked && inNames ? items.filter((item) => has(plain(item.id))) : []);
      const whole = !hits.size || items.some((item) => hits.has(item) && item.tagName !== "TR");
      for (const item of items) {
        item.classList.toggle("hit", hits.has(item));
        if (item.tagName === "TR") item.hidden = !whole && !hits.has(item);
        else if (asked && !inNames && shown) ++count;
      }
      count += hits.size;
    }
    for (const section of all("main section")) {
      section.hidden = asked && !all(".entry:not([hidden])", section).length;
      for (const text of section.children)
        if (!text.matches("h2, h3, .entry, section")) text.hidden = asked;
    }
    document.querySelector(".intro").hidden = asked;
    for (const { element, name, target } of links.filter((link) => !link.element.className))
      element.parentNode.hidden = asked && !(target.hasAttribute("data-item") && (inNames ? has(name)
        : target.tagName !== "TR" && !target.closest("[hidden]")));
    for (const part of all("nav ul details")) {
      const shown = all("li:not([hidden])", part).length > 0;
      part.parentNode.hidden = asked && !shown;
      part.open = asked && shown;
    }
    for (const header of all("nav .of-header")) {
      header.hidden = false;
      header.hidden = asked && all("li", header).every((item) => item.closest("[hidden]"));
    }
    found.textContent = asked ? (count ? `${count} ${inNames ? "found" : "in the text"}` : "none") : "";
    if (!asked) follow();
  }

  // What a link leads to is shown, whatever is looked for, and its place in the contents opened.
  function follow() {
    const id = decodeURIComponent(location.hash.slice(1)), target = id && document.getElementById(id);
    if (!target) return;
    if (target.closest("[hidden]")) {
      field.value = "";
      filter();
    }
    for (const { element } of links) {
      const here = element.getAttribute("href") === location.hash;
      if (here) element.setAttribute("aria-current", "location");
      else element.removeAttribute("aria-current");
      if (here && element.closest("nav ul details")) element.closest("nav ul details").open = true;
    }
    target.scrollIntoView();
  }

  field.addEventListener("input", filter);
  field.form.addEventListener("submit", (event) => {
    event.preventDefault();
    const first = document.querySelector("main .entry:not([hidden]) .hit, main .entry:not([hidden]) [data-item]");
    if (field.value.trim() && first) location.hash = first.id;
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "/" && event.target !== field && !event.ctrlKey && !event.metaKey && !event.altKey) {
      event.preventDefault();
      field.focus();
      field.select();
    } else if (event.key === "Escape" && event.target === field) {
      field.value = "";
      filter();
    }
  });
  addEventListener("hashchange", follow);
  wide.addEventListener("change", () => { contents.open = wide.matches; });
  contents.open = wide.matches;
  follow();
})();
