;;; What the tests of Emacs share.  -*- lexical-binding: t -*-
(require 'cl-lib)
(defun need (what test)
  "Wait until TEST holds, or end with an error that says WHAT was missing."
  (let ((end (+ (float-time) 20)) (held nil))
    (while (and (not (setq held (funcall test))) (< (float-time) end))
      (accept-process-output nil 0.02))
    (message "%s %s" (if held "ok  " "FAIL") what)
    (unless held (kill-emacs 1))))
(defun goto-after (text)
  (goto-char (point-min))
  (search-forward text))
(defun replace-first (old new)
  (goto-after old)
  (replace-match new t t)
  ;; without a terminal nobody is ever idle, and clients wait for that
  (when (fboundp 'eglot--signal-textDocument/didChange) (eglot--signal-textDocument/didChange)))
(setq make-backup-files nil auto-save-default nil create-lockfiles nil)
