using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Inspection.Variety;

namespace CreatureGen.Inspection;

/// <summary>Measures how different creatures are. Add them one by one; a creature need not be kept once it is added.</summary>
/// <remarks>About 4 kB are kept for each creature, and each is compared with each: a thousand take some seconds.</remarks>
public sealed class VarietyStudy
{
    /// <summary>Two creatures are doubles when their outlines from side, front and above, drawn alike large on 96 by 96 pixels, share this part of the area that they cover together.</summary>
    public const double TwinLikeness = 0.8;

    /// <summary>Number of most alike pairs in a report.</summary>
    public const int NearestPairs = 18;

    private readonly List<Silhouette> outlines = new();
    private readonly List<string> combinations = new();
    private readonly List<string> withHeads = new();
    private int chimeras;

    /// <summary>Adds a creature.</summary>
    /// <exception cref="ArgumentNullException">There is no creature.</exception>
    public void Add(Creature creature)
    {
        if (creature is null)
        {
            throw new ArgumentNullException(nameof(creature));
        }

        CreatureBlueprint blueprint = creature.Blueprint;
        outlines.Add(new Silhouette(creature.Mesh.Positions, creature.Mesh.Triangles));
        string combination = CombinationOf(blueprint);
        combinations.Add(combination);
        withHeads.Add(combination + " " + blueprint.Body.Blend.Face);
        chimeras += ChimeraDistance.Of(blueprint) >= ChimeraDistance.Nameless ? 1 : 0;
    }

    /// <summary>What has been found so far.</summary>
    public VarietyReport Report()
    {
        int count = outlines.Count;
        var pairs = new List<LikePair>();
        bool[] twins = new bool[count];
        int[] leader = new int[count];
        for (int i = 0; i < count; i++)
        {
            leader[i] = i;
            for (int k = 0; k < i; k++)
            {
                double likeness = outlines[i].Likeness(outlines[k]);
                Keep(pairs, new LikePair(k, i, likeness));
                if (likeness >= TwinLikeness)
                {
                    twins[i] = twins[k] = true;
                    leader[Root(leader, i)] = Root(leader, k);
                }
            }
        }

        int doubles = 0;
        int clusters = 0;
        for (int i = 0; i < count; i++)
        {
            doubles += twins[i] ? 1 : 0;
            clusters += leader[i] == i ? 1 : 0;
        }

        double each = Math.Max(1, count);
        return new VarietyReport(count, doubles / each, Effective(combinations), Effective(withHeads), chimeras / each, clusters, pairs);
    }

    private static int Root(int[] leader, int i)
    {
        while (leader[i] != i)
        {
            i = leader[i];
        }

        return i;
    }

    private static void Keep(List<LikePair> pairs, LikePair pair)
    {
        int place = pairs.Count;
        while (place > 0 && pairs[place - 1].Likeness < pair.Likeness)
        {
            place--;
        }

        if (place < NearestPairs)
        {
            pairs.Insert(place, pair);
            if (pairs.Count > NearestPairs)
            {
                pairs.RemoveAt(NearestPairs);
            }
        }
    }

    /// <summary>N(N−1) / Σn(n−1).</summary>
    private static double Effective(List<string> kinds)
    {
        var sorted = new List<string>(kinds);
        sorted.Sort(StringComparer.Ordinal);
        double repeated = 0;
        int alike = 0;
        for (int i = 1; i < sorted.Count; i++)
        {
            alike = string.Equals(sorted[i], sorted[i - 1], StringComparison.Ordinal) ? alike + 1 : 0;
            repeated += 2 * alike;
        }

        return sorted.Count < 2 ? sorted.Count : (double)sorted.Count * (sorted.Count - 1) / Math.Max(2, repeated);
    }

    /// <summary>Body, plan and how many limbs of which form.</summary>
    private static string CombinationOf(CreatureBlueprint blueprint)
    {
        var text = new StringBuilder();
        text.Append(blueprint.Body.Blend.First).Append(' ').Append(AnatomyChoices.Plan.NameOf(blueprint.Plan));
        foreach (LegBlueprint leg in blueprint.Legs)
        {
            text.Append(' ').Append(AnatomyChoices.Archetype.NameOf(leg.Archetype)).Append(leg.Stance == LegStance.Standing ? "" : "-");
        }

        foreach (WingBlueprint wing in blueprint.Wings)
        {
            text.Append(' ').Append(AnatomyChoices.Wing.NameOf(wing.Style));
        }

        text.Append(' ').Append(blueprint.InsectWings.Count.ToString(CultureInfo.InvariantCulture));
        foreach (FinBlueprint fin in blueprint.Fins)
        {
            text.Append(' ').Append(AnatomyChoices.FinPlace.NameOf(fin.Place)).Append(AnatomyChoices.Fin.NameOf(fin.Style));
        }

        return text.ToString();
    }
}
