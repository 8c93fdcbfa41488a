// The viewer believes that it runs in a webview of an editor; the editor is the page around this frame.
window.acquireVsCodeApi = () => ({ postMessage: (message) => parent.postMessage(message, location.origin) });
