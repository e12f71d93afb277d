// Which borders of the view are covered by bars and panels.

import type { Insets } from '../camera/framing';

const visibleBox = (id: string): DOMRect | undefined => {
  const box = document.getElementById(id)?.getBoundingClientRect();
  return box && box.width > 0 && box.height > 0 ? box : undefined;
};

/** In pixels. */
export function layoutInsets(width: number, height: number): Insets {
  const bottom = visibleBox('bottom');
  const bar = visibleBox('bar');
  const left = openPanels('dock-left');
  const right = openPanels('dock-right');
  const top = Math.max(bar?.bottom ?? 0, visibleBox('banner')?.bottom ?? 0);
  const sheets = [...left, ...right].filter((box) => box.width > 0.8 * width);
  if (sheets.length > 0) return { top, right: 0, bottom: height - Math.min(...sheets.map((box) => box.top)), left: 0 };
  return {
    top,
    right: right.length > 0 ? width - Math.min(...right.map((box) => box.left)) : 0,
    bottom: bottom ? height - bottom.top : 0,
    left: left.length > 0 ? Math.max(...left.map((box) => box.right)) : 0,
  };
}

function openPanels(dock: string): DOMRect[] {
  return [...(document.getElementById(dock)?.children ?? [])].map((panel) => panel.getBoundingClientRect()).filter((box) => box.height > 0);
}
