// Light or dark: as the documentation around the playground, else as the system.

const DARK = ['coal', 'navy', 'ayu'];
const system = matchMedia('(prefers-color-scheme: dark)');

export type Theme = 'light' | 'dark';

/** Follow the theme; `changed` is called with each one, also the first. */
export function follow(button: HTMLElement, changed: (theme: Theme) => void): void {
  let chosen = stored();
  const apply = (): void => {
    const theme = chosen ?? (system.matches ? 'dark' : 'light');
    document.documentElement.dataset['theme'] = theme;
    changed(theme);
  };
  system.addEventListener('change', apply);
  button.addEventListener('click', () => {
    chosen = document.documentElement.dataset['theme'] === 'dark' ? 'light' : 'dark';
    try {
      localStorage.setItem('mdbook-theme', chosen === 'dark' ? 'navy' : 'light');
    } catch {
      // a browser that keeps nothing
    }
    apply();
  });
  apply();
}

function stored(): Theme | undefined {
  try {
    const name = localStorage.getItem('mdbook-theme');
    return name === null ? undefined : DARK.includes(name) ? 'dark' : 'light';
  } catch {
    return undefined;
  }
}
