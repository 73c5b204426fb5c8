// Buttons that copy a line. Without them it is selected by a click all the same.
"use strict";
for (const button of document.querySelectorAll(".copy button"))
  button.addEventListener("click", async () => {
    await navigator.clipboard?.writeText(button.previousElementSibling.textContent);
    button.textContent = "Copied";
  });
