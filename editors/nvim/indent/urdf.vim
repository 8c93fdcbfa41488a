if !exists('b:did_indent')
  runtime! indent/xml.vim
endif
