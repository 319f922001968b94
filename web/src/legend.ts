/** The legend of the chosen colour. */
import { element, make, say } from "./elements";
import { tickText, ticks, unitText } from "./numbers";
import type { Viewer } from "./viewer";

export class Legend {
  private readonly box = element("legend");
  private readonly label = element("legend-label");
  private readonly bar = element("legend-bar");
  private readonly marks = element("legend-ticks");
  private shown = "";

  refresh(viewer: Viewer): void {
    const { motion, colour } = viewer;
    const number = motion.show.colours.findIndex((one) => one.name === colour);
    this.box.hidden = number < 0;
    const shown = `${motion.show.name}\n${colour}`;
    if (number < 0 || shown === this.shown) return;
    this.shown = shown;
    const { low, high, colours } = motion.scales[number];
    say(this.label, legendText(viewer));
    this.bar.style.background = `linear-gradient(to right, ${colours.join(", ")})`;
    const marks = ticks(low, high, 5).map((value) => {
      const mark = make("span", tickText(value));
      mark.style.left = `${(100 * (value - low)) / (high - low)}%`;
      return mark;
    });
    this.marks.replaceChildren(...marks);
  }
}

export function legendText(viewer: Viewer): string {
  const colour = viewer.motion.show.colours.find((one) => one.name === viewer.colour);
  if (!colour) return "";
  return [colour.label || colour.name, unitText(colour.unit)].filter((part) => part !== "").join(", ");
}
