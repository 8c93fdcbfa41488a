{
  description = "Linter and language server for xacro and URDF robot descriptions";

  inputs.nixpkgs.url = "github:NixOS/nixpkgs/nixos-unstable";

  outputs =
    { self, nixpkgs }:
    let
      systems = [
        "x86_64-linux"
        "aarch64-linux"
        "x86_64-darwin"
        "aarch64-darwin"
      ];
      forEach = nixpkgs.lib.genAttrs systems;
    in
    {
      packages = forEach (
        system:
        let
          pkgs = nixpkgs.legacyPackages.${system};
        in
        {
          default = pkgs.rustPlatform.buildRustPackage {
            pname = "xacro-lint";
            version = "@VERSION@";
            src = self;
            cargoLock.lockFile = ./Cargo.lock;
            # the tests need the network
            doCheck = false;
            meta = {
              description = "Linter and language server for xacro and URDF robot descriptions";
              license = with pkgs.lib.licenses; [
                mit
                asl20
              ];
              mainProgram = "xacro-lint";
            };
          };
        }
      );
      apps = forEach (system: {
        default = {
          type = "app";
          program = "${self.packages.${system}.default}/bin/xacro-lint";
        };
      });
    };
}
