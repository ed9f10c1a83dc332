using System.Collections.Generic;
using System.IO;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;

namespace CreatureGen.Digest;

/// <summary>Blueprints that are kept as text for good when a format is new: a dozen creatures that together have something in every list.</summary>
public static class SavedCreatures
{
    private const int Triangles = 6000;

    private static readonly (RequestedKind Kind, ulong Seed, BodyPlan? Plan)[] creatures =
    {
        (RequestedKind.Walking, 12, null),
        (RequestedKind.Walking, 16, null),
        (RequestedKind.Walking, 18, null),
        (RequestedKind.Walking, 20, null),
        (RequestedKind.Walking, 24, null),
        (RequestedKind.Walking, 41, BodyPlan.Centaur),
        (RequestedKind.Walking, 41, BodyPlan.ManyLegged),
        (RequestedKind.Flying, 10, null),
        (RequestedKind.Flying, 17, null),
        (RequestedKind.Swimming, 1, null),
        (RequestedKind.Swimming, 9, null),
        (RequestedKind.Swimming, 17, null),
    };

    /// <summary>Writes the texts of the format that the library writes now into a folder of its own and returns its path.</summary>
    public static string Write(string folder)
    {
        string own = Path.Combine(folder, "format-" + BlueprintJson.FormatVersion);
        Directory.CreateDirectory(own);
        foreach ((RequestedKind kind, ulong seed, BodyPlan? plan) in creatures)
        {
            var plans = new List<BodyPlanWeight>();
            if (plan is { } only)
            {
                plans.Add(new BodyPlanWeight(only, 1000));
            }

            CreatureOptions options = CreatureOptions.Default with { Kind = kind, TriangleBudget = Triangles, BodyPlans = new ValueList<BodyPlanWeight>(plans) };
            string name = (plan?.ToString() ?? kind.ToString()).ToLowerInvariant();
            File.WriteAllText(Path.Combine(own, $"{name}-{seed}.json"), BlueprintJson.Write(BlueprintSampler.Sample(seed, options)));
        }

        return own;
    }
}
