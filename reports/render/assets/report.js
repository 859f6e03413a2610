// Filters the matrix of cases on the overview. The page says everything without it.
(() => {
  const filter = document.querySelector(".filter");
  if (!filter) return;
  filter.hidden = false;
  const find = document.getElementById("find");
  const strict = document.getElementById("not-passed");
  const apply = () => {
    const words = find.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const body of document.querySelectorAll(".matrix tbody")) {
      const group = (body.querySelector(".group")?.textContent ?? "").toLowerCase();
      let shown = 0;
      for (const row of body.querySelectorAll(".row")) {
        const text = group + " " + row.textContent.toLowerCase();
        row.hidden = !words.every(word => text.includes(word)) || (strict.checked && row.dataset.pass === "yes");
        shown += !row.hidden;
      }
      body.hidden = shown === 0;
    }
  };
  find.addEventListener("input", apply);
  strict.addEventListener("change", apply);
})();
