// On a phone the links of the head fold behind a button.
const head = document.querySelector("nav.top"), menu = head.querySelector(".menu");
head.classList.add("foldable");
menu.addEventListener("click", () => menu.setAttribute("aria-expanded", head.classList.toggle("open")));

// Tables that are wider than the page can be moved from the keyboard.
for (const box of document.querySelectorAll(".scroll")) if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;

// Figures answer on request: their file, whose script gives values, series and films, takes the place of its picture.
for (const plate of document.querySelectorAll("a.plate[data-live]")) {
  const button = document.createElement("button"), picture = plate.firstElementChild;
  button.className = "live";
  button.textContent = plate.dataset.live;
  button.addEventListener("click", () => {
    const live = document.createElement("object");
    live.type = "image/svg+xml";
    live.data = plate.href + "#play";
    live.ariaLabel = picture.alt;
    live.style.cssText = `display: block; width: 100%; aspect-ratio: ${picture.clientWidth} / ${picture.clientHeight}`;
    plate.replaceWith(live);
    button.remove();
  });
  plate.parentElement.querySelector("figcaption").append(" ", button);
}

// Search, filters and sorting of the first screen; all of them stand in the address. The page says everything without it.
(() => {
  const tools = document.querySelector(".tools");
  if (!tools) return;
  tools.hidden = false;
  const find = document.getElementById("find"), failures = document.getElementById("failures");
  const hits = document.getElementById("hits"), count = document.getElementById("hits-count");
  const kinds = [...tools.querySelectorAll("[name=evidence]")], choices = [...tools.querySelectorAll("select")];
  const body = document.querySelector(".grid tbody"), rows = [...body.rows];
  const heads = [...document.querySelectorAll(".grid th[data-sort]")];
  let sorted = "";

  const words = () => {
    const synonyms = window.searchIndex?.synonyms ?? {};
    let text = find.value.toLowerCase();
    for (const [said, meant] of Object.entries(synonyms)) text = text.replace(said, meant);
    return text.split(/\s+/).filter(Boolean);
  };
  const all = (wanted, text) => wanted.every(word => text.includes(word));
  const typed = () => find.value.toLowerCase().split(/\s+/).filter(Boolean);

  const apply = () => {
    const wanted = words(), asTyped = typed();
    let shown = 0;
    for (const row of rows) {
      const text = (row.textContent + " " + row.dataset.words).toLowerCase();
      row.hidden = !(all(wanted, text) || all(asTyped, text)) || (failures.checked && row.dataset.flaw === "no")
        || choices.some(choice => choice.value && choice.value !== row.dataset[choice.name])
        || !kinds.some(kind => kind.checked && kind.value === row.dataset.evidence);
      shown += !row.hidden;
    }
    const entries = asTyped.length ? (window.searchIndex?.entries ?? []).filter(([title, , text]) =>
      all(wanted, (title + " " + text).toLowerCase()) || all(asTyped, (title + " " + text).toLowerCase())) : [];
    hits.hidden = !entries.length;
    hits.replaceChildren(...entries.slice(0, 12).map(([title, page]) => {
      const item = document.createElement("li"), link = document.createElement("a");
      link.href = page;
      link.textContent = title;
      item.append(link);
      return item;
    }));
    count.textContent = asTyped.length ? `${shown} rows, ${entries.length} pages` : shown < rows.length ? `${shown} rows` : "";
    const state = new URLSearchParams();
    if (find.value) state.set("q", find.value);
    if (failures.checked) state.set("flaw", "1");
    for (const choice of choices) if (choice.value) state.set(choice.name, choice.value);
    const off = kinds.filter(kind => !kind.checked).map(kind => kind.value);
    if (off.length) state.set("without", off.join(","));
    if (sorted) state.set("sort", sorted);
    history.replaceState(null, "", String(state) ? "#" + state : location.pathname + location.search);
  };

  const sortBy = (column, descending) => {
    const head = heads.find(one => one.cellIndex === column);
    if (!head) return;
    const key = row => {
      const cell = row.cells[column];
      if (head.dataset.sort === "text") return cell.textContent;
      const value = parseFloat(cell.dataset.value ?? cell.textContent);
      return Number.isNaN(value) ? Infinity : value;
    };
    heads.forEach(one => one.removeAttribute("aria-sort"));
    head.setAttribute("aria-sort", descending ? "descending" : "ascending");
    const before = (a, b) => a < b ? -1 : a > b ? 1 : 0;
    rows.sort((a, b) => {
      const [x, y] = [key(a), key(b)];
      return x === Infinity || y === Infinity || !descending ? before(x, y) : before(y, x);
    });
    body.append(...rows);
    sorted = `${column}${descending ? "d" : ""}`;
  };

  for (const head of heads) {
    const button = document.createElement("button");
    button.textContent = "↕";
    button.setAttribute("aria-label", "Sort by " + head.textContent);
    button.addEventListener("click", () => {
      sortBy(head.cellIndex, head.getAttribute("aria-sort") === "ascending");
      apply();
    });
    head.append(" ", button);
  }
  const load = () => {
    if (window.searchIndex || document.getElementById("search-index")) return;
    const script = document.createElement("script");
    script.id = "search-index";
    script.src = document.body.dataset.root + "assets/search.js";
    script.addEventListener("load", apply);
    document.head.append(script);
  };
  find.addEventListener("focus", load);
  find.addEventListener("input", () => { load(); apply(); });
  for (const box of [failures, ...kinds, ...choices]) box.addEventListener("change", apply);
  addEventListener("keydown", event => {
    if (event.key === "/" && document.activeElement !== find) {
      event.preventDefault();
      find.focus();
    } else if (event.key === "Escape") {
      find.value = "";
      apply();
    }
  });

  const state = new URLSearchParams(location.hash.slice(1));
  if ([...state.keys()].some(key => ["q", "flaw", "without", "sort", "problem", "quantity"].includes(key))) {
    find.value = state.get("q") ?? "";
    failures.checked = state.has("flaw");
    for (const choice of choices) choice.value = state.get(choice.name) ?? "";
    for (const kind of kinds) kind.checked = !(state.get("without") ?? "").split(",").includes(kind.value);
    if (state.has("sort")) sortBy(parseInt(state.get("sort")), state.get("sort").endsWith("d"));
    if (find.value) load();
    apply();
  }
})();
