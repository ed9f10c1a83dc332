using CreatureGen.Blueprints;

namespace CreatureGen.Lab.Runtime;

/// <summary>The blueprint of a seed, drawn up before it is asked for.</summary>
/// <param name="Seed">Of the creature, or of its species.</param>
/// <param name="Kind">How it gets about.</param>
/// <param name="Strangeness">0..1.</param>
/// <param name="Individual">Which one of the species; empty for the creature of the seed itself.</param>
internal sealed record Sketch(string Seed, string Kind, double Strangeness, string Individual)
{
    private readonly CreatureBlueprint design = DesignText.Sample(Seed, Kind, Strangeness, Individual);

    /// <summary>The blueprint, if it is that of this seed.</summary>
    public CreatureBlueprint? Of(string seed, string kind, double strangeness, string individual) =>
        (Seed, Kind, Strangeness, Individual) == (seed, kind, strangeness, individual) ? design : null;
}
