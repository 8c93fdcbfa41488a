#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| xacro_lsp_fuzz::launch_requests(data));
