namespace CreatureGen.Tests.Console;

/// <summary>Options that leave some seeds without a creature.</summary>
internal static class RareCreatures
{
    /// <summary>Nearly always serpents, and these cannot have four pairs of legs: some of the seeds 1 to 8 give none.</summary>
    public const string Options =
        "--kind walking --leg-pairs 4-4 --bodies serpent=300 --plans digitigrade=0,unguligrade=0,plantigrade=0,columnar=0,sprawling=0,theropod=0,upright=0,hexapod=0,legless=0,centaur=0";
}
