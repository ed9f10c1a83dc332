using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;

namespace CreatureGen.Lab.Runtime;

/// <summary>A part that can be put on a creature and taken off.</summary>
/// <param name="Name">What the page calls it.</param>
/// <param name="Has">Whether a creature has it.</param>
/// <param name="Give">The creature with the donor's part in place of its own.</param>
/// <param name="Take">The creature without.</param>
internal sealed record Part(string Name, Predicate<CreatureBlueprint> Has, Func<CreatureBlueprint, CreatureBlueprint, CreatureBlueprint> Give, Func<CreatureBlueprint, CreatureBlueprint> Take);

/// <summary>The palette of parts. All bodies are grown on one lattice of rings and segments, so a part sits on another body where it sat on its own; repair sees to the rest.</summary>
internal static class PartBox
{
    /// <summary>Creatures that are asked for a part at most.</summary>
    private const int MaxDonors = 600;

    private static readonly RequestedKind[] kinds = [RequestedKind.Walking, RequestedKind.Flying, RequestedKind.Swimming];

    public static readonly IReadOnlyList<Part> All =
    [
        Feature("horns", FeatureKind.Horn),
        Feature("antlers", FeatureKind.Antler),
        new("ears", b => b.Ears.Count > 0, (b, donor) => b with { Ears = donor.Ears }, b => b with { Ears = new([]) }),
        Feature("feelers", FeatureKind.Antenna),
        Feature("tusks", FeatureKind.Tusk),
        Feature("jaws", FeatureKind.Mandible),
        Feature("spikes", FeatureKind.Spike),
        Feature("plates", FeatureKind.Plate),
        Feature("tuft", FeatureKind.Tuft),
        new("mane", b => b.Manes.Count > 0, (b, donor) => b with { Manes = donor.Manes }, b => b with { Manes = new([]) }),
        new("frill", b => b.Frills.Count > 0, (b, donor) => b with { Frills = donor.Frills }, b => b with { Frills = new([]) }),
        new("shell", b => b.Body.Shell.Style != ShellStyle.None, (b, donor) => b with { Body = b.Body with { Shell = donor.Body.Shell } }, b => b with { Body = b.Body with { Shell = b.Body.Shell with { Style = ShellStyle.None } } }),
        new("wings", b => b.Wings.Count > 0, (b, donor) => b with { Wings = donor.Wings }, b => b with { Wings = new([]) }),
        new("insectWings", b => b.InsectWings.Count > 0, (b, donor) => b with { InsectWings = donor.InsectWings }, b => b with { InsectWings = new([]) }),
        new("fins", b => b.Fins.Count > 0, (b, donor) => b with { Fins = donor.Fins }, b => b with { Fins = new([]) }),
        new("tailEnd", b => b.Tail.Style != TailStyle.Plain, (b, donor) => b with { Tail = donor.Tail }, b => b with { Tail = b.Tail with { Style = TailStyle.Plain } }),
        Feature("club", FeatureKind.Club),
        Feature("lure", FeatureKind.Lure),
        new("eyes", _ => true, (b, donor) => b with { Head = b.Head with { Eyes = donor.Head.Eyes } }, b => b),
        new("coat", _ => true, (b, donor) => b with { Coat = donor.Coat }, b => b),
    ];

    public static Part Find(string name) => All.FirstOrDefault(part => part.Name == name) ?? throw new ArgumentException("there is no part \u201c" + name + "\u201d");

    /// <summary>The creature with a part of another's: the next creature from a seed on that has one.</summary>
    /// <param name="design">Who gets it.</param>
    /// <param name="part">What.</param>
    /// <param name="seed">The first seed that is asked.</param>
    public static CreatureBlueprint Give(CreatureBlueprint design, Part part, ulong seed)
    {
        for (ulong n = 0; n < MaxDonors; n++)
        {
            CreatureBlueprint donor = BlueprintSampler.Sample(seed + (n / 3), CreatureOptions.Default with { Kind = kinds[(int)(n % 3)], Strangeness = 0 });
            if (part.Has(donor))
            {
                return part.Give(design, ShortNumbers.Of(donor));
            }
        }

        throw new ArgumentException("nobody here has any; try again");
    }

    private static Part Feature(string name, FeatureKind kind) => new(
        name,
        b => b.Features.Any(feature => feature.Kind == kind),
        (b, donor) => b with { Features = new([.. Others(b, kind), .. donor.Features.Where(feature => feature.Kind == kind)]) },
        b => b with { Features = new([.. Others(b, kind)]) });

    private static IEnumerable<FeatureBlueprint> Others(CreatureBlueprint blueprint, FeatureKind kind) => blueprint.Features.Where(feature => feature.Kind != kind);
}
