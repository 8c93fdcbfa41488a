"""Coding assistants: `xacro-lint mcp` asked by the official client of the protocol."""

import json

from common import EXAMPLES, RELEASE, demand, fresh, run, tool

CLIENT = """
import asyncio, json, sys
from mcp import ClientSession, StdioServerParameters
from mcp.client.stdio import stdio_client

async def ask():
    program, folder, calls = sys.argv[1], sys.argv[2], json.loads(sys.argv[3])
    async with stdio_client(StdioServerParameters(command=program, args=["mcp", folder])) as (read, write):
        async with ClientSession(read, write) as session:
            await session.initialize()
            tools = [tool.name for tool in (await session.list_tools()).tools]
            answers = []
            for name, arguments in calls:
                answer = await session.call_tool(name, arguments)
                answers.append([part.model_dump(by_alias=True, mode="json") for part in answer.content])
            print(json.dumps({"tools": tools, "answers": answers}))

asyncio.run(ask())
"""


def client():
    """Its session starts, lists the tools, and gets findings, a page and a picture."""
    client = fresh("assistants") / "client.py"
    client.write_text(CLIENT)
    robot = "src/broken_cell/urdf/broken_cell.xacro"
    calls = [["check", {}], ["explain", {"rule": "undefined-link"}], ["render", {"file": robot}]]
    folder = EXAMPLES / "broken_cell"
    said = json.loads(run([tool("python"), client, RELEASE / "xacro-lint", folder, json.dumps(calls)]))
    demand({"check", "explain", "render"} <= set(said["tools"]), f"tools: {said['tools']}")
    check, explain, render = said["answers"]
    demand(json.loads(check[0]["text"]), "check finds nothing in an example with defects")
    demand("undefined-link" in explain[0]["text"], explain[0]["text"])
    demand(render[0]["mimeType"] == "image/png", str(render)[:300])
