"""Publish the robot; `gripper:=false` leaves the gripper out."""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    model = PathJoinSubstitution([FindPackageShare('two_joint_gripper_description'), 'urdf',
                                  'two_joint_gripper.urdf.xacro'])
    text = Command(['xacro ', model, ' gripper:=', LaunchConfiguration('gripper')])
    return LaunchDescription([
        DeclareLaunchArgument('gripper', default_value='true'),
        Node(package='robot_state_publisher', executable='robot_state_publisher',
             parameters=[{'robot_description': ParameterValue(text, value_type=str)}]),
    ])
