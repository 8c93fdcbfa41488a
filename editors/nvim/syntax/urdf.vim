if !exists('b:current_syntax')
  runtime! syntax/xacro.vim
  let b:current_syntax = 'urdf'
endif
