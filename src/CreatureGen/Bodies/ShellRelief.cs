using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Bodies;

/// <summary>How a shell swells the sections of the body that wears it: it is the skin itself, so it leaves no gap and bends with the body.</summary>
internal static class ShellRelief
{
    /// <summary>How much further than the rest the rim stands off.</summary>
    private const double CarapaceRim = 1.9;

    private const double CarapaceEnds = 1.2;
    private const double ElytraRim = 1.25;

    /// <summary>Height of the suture between wing cases.</summary>
    private const double Suture = 0.15;

    /// <summary>Depth of the grooves between plates, relative to the section.</summary>
    private const double Groove = 0.02;

    /// <summary>Whether a ring and segment of the left half (0 dorsal to 16 ventral) are covered.</summary>
    public static bool Covers(ShellBlueprint shell, int ring, int segment) =>
        shell.Style != ShellStyle.None && ring >= shell.Ring && ring <= shell.Ring + shell.Rows && segment <= shell.Columns;

    /// <summary>The greatest factor on the section at a ring.</summary>
    public static double Greatest(ShellBlueprint shell, int ring) =>
        Covers(shell, ring, 0) ? 1 + (shell.Rise * (shell.Style == ShellStyle.Elytra ? ElytraRim : CarapaceRim)) : 1;

    /// <summary>The factor on the section at a ring and segment of the left half.</summary>
    public static double Factor(ShellBlueprint shell, int ring, int segment)
    {
        if (!Covers(shell, ring, segment))
        {
            return 1;
        }

        return shell.Style == ShellStyle.Elytra ? Elytra(shell, segment) : Carapace(shell, ring, segment);
    }

    private static double Elytra(ShellBlueprint shell, int segment) =>
        1 + (shell.Rise * (segment == 0 ? Suture : segment == shell.Columns ? ElytraRim : 1));

    private static double Carapace(ShellBlueprint shell, int ring, int segment)
    {
        int before = ring - shell.Ring;
        int behind = shell.Ring + shell.Rows - ring;
        if (before == 0 || behind == 0)
        {
            return 1 + (shell.Rise * CarapaceEnds);
        }

        if (segment == shell.Columns)
        {
            return 1 + (shell.Rise * CarapaceRim);
        }

        double dome = Math.Min(1, 0.55 + (0.15 * Math.Min(before, behind)));
        bool groove = before % 4 == 2 || segment % 4 == 2;
        return 1 + (shell.Rise * dome) - (groove ? Groove : 0);
    }
}
