using System;
using System.Linq;
using System.Numerics;
using System.Text;
using CreatureGen.Engines;

namespace CreatureGen.Tests.Engines;

/// <summary>The table of engines in docs/using-it.md.</summary>
internal static class EngineTable
{
    public static string Markdown()
    {
        var text = new StringBuilder();
        text.Append("| engine | axes | point (x, y, z) | rotation (x, y, z, w) | tangent (x, y, z, w) | corners of a triangle | texture v | 16 floats of a matrix |\n");
        text.Append("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
        foreach (IGrouping<string, EngineAxes> row in EngineAxes.All.GroupBy(Cells))
        {
            text.Append("| ").AppendJoin(", ", row.Select(e => e.Name)).Append(" | ").Append(row.Key).Append(" |\n");
        }

        return text.ToString();
    }

    private static string Cells(EngineAxes e)
    {
        string way = Triple(e, 1f);
        string unit = e.UnitsPerMetre == 1f ? way : FormattableString.Invariant($"{e.UnitsPerMetre} · {way}");
        string side = e.IsLeftHanded ? "−w" : "w";
        return string.Join(" | ",
            $"{(e.IsLeftHanded ? "left" : "right")}-handed, {Axis(e.Up)} up, {Axis(e.Ahead)} ahead, {(e.UnitsPerMetre == 100f ? "centimetres" : "metres")}",
            unit,
            Triple(e, e.IsLeftHanded ? -1f : 1f)[..^1] + ", w)",
            way[..^1] + $", {side})",
            e.FrontFace == FrontFace.Clockwise ? "0, 2, 1" : "0, 1, 2",
            e.TextureOrigin == TextureOrigin.TopLeft ? "v" : "1 − v",
            e.MatrixMemory == MatrixMemory.AxisByAxis ? "axis by axis" : "transposed");
    }

    private static string Axis(Vector3 a) => (a.X + a.Y + a.Z > 0f ? "+" : "−") + "XYZ"[a.X != 0f ? 0 : a.Y != 0f ? 1 : 2];

    /// <summary>Which of the library's components, with which sign, each of the engine's is.</summary>
    private static string Triple(EngineAxes e, float sign)
    {
        string Component(float x, float y, float z) => ((x + y + z) * sign > 0f ? "" : "−") + (x != 0f ? "x" : y != 0f ? "y" : "z");
        return $"({Component(e.Left.X, e.Up.X, e.Ahead.X)}, {Component(e.Left.Y, e.Up.Y, e.Ahead.Y)}, {Component(e.Left.Z, e.Up.Z, e.Ahead.Z)})";
    }
}
