using System;
using System.Collections.Generic;
using System.Linq;

namespace CreatureGen.Sampling;

/// <summary>All profiles: the nine families, then their species. A further species is a further entry of one of these lists, and a table of the same name among the bodies.</summary>
internal static class SpeciesCatalogue
{
    private static readonly SpeciesProfile[] all = new[]
    {
        FamilyProfiles.All, InsectSpecies.All, SwimmerSpecies.All, BirdSpecies.All, CrawlerSpecies.All, MammalSpecies.All, FlierSpecies.All, SaurianSpecies.All,
    }.SelectMany(profiles => profiles).ToArray();

    /// <summary>Every profile, in a fixed order.</summary>
    public static IReadOnlyList<SpeciesProfile> All => all;

    /// <summary>Names of the other species of the same family that mix well with it.</summary>
    public static string[] SiblingsOf(SpeciesProfile species)
    {
        var siblings = new List<string>();
        foreach (SpeciesProfile other in all)
        {
            if (other.IsSpecies && other.Family == species.Family && other.Body != species.Body && other.Dominance.Least < 0.93)
            {
                siblings.Add(other.Body);
            }
        }

        return siblings.ToArray();
    }

    private static IEnumerable<SpeciesProfile> WithOwnSpecies(SpeciesProfile family) =>
        MammalSpecies.All.Concat(SaurianSpecies.All).Where(species => species.Family == family.Family).Prepend(family);

    /// <summary>The profile of a base body.</summary>
    /// <exception cref="ArgumentException">There is none.</exception>
    public static SpeciesProfile Find(string body) =>
        Array.Find(all, species => species.Body == body) ?? throw new ArgumentException($"there is no profile of \"{body}\"; expected the name of a base body", nameof(body));
}
