from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import Command, LaunchConfiguration
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    side = LaunchConfiguration("side")
    robot = Command(["xacro ", FindPackageShare("arm"), "/urdf/arm.urdf.xacro", " side:=", side, " simm:=true"])
    return LaunchDescription([DeclareLaunchArgument("side"), robot])
