using System;

namespace CreatureGen.Tests;

/// <summary>How much of a claim over many is tried: a sample after each change, all of it before one goes in.</summary>
internal static class Thoroughness
{
    /// <summary>Whether all is tried: with CREATUREGEN_EXHAUSTIVE=true in the environment, as <c>.ci/run</c> has it.</summary>
    public static bool IsExhaustive { get; } = Environment.GetEnvironmentVariable("CREATUREGEN_EXHAUSTIVE") == "true";

    /// <summary>As many of a number of cases as are tried: all, or a third.</summary>
    public static int Of(int cases) => IsExhaustive ? cases : (cases + 2) / 3;
}
