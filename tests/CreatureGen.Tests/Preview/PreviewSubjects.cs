using System;
using System.Collections.Concurrent;
using CreatureGen.Creatures;
using CreatureGen.Preview.Scenes;
using Xunit;

namespace CreatureGen.Tests.Preview;

/// <summary>Creatures of all kinds, grown once.</summary>
internal static class PreviewSubjects
{
    private static readonly ConcurrentDictionary<ulong, Lazy<Creature>> creatures = new();

    /// <summary>Seeds and views, as theory data.</summary>
    public static TheoryData<ulong, View> SeedsAndViews { get; } = MakeSeedsAndViews();

    public static Creature Of(ulong seed) => creatures.GetOrAdd(seed, s => new Lazy<Creature>(() => CreatureGenerator.Generate(s))).Value;

    private static TheoryData<ulong, View> MakeSeedsAndViews()
    {
        var data = new TheoryData<ulong, View>();
        for (ulong seed = 1; seed <= (ulong)Thoroughness.Of(8); seed++)
        {
            foreach (View view in Enum.GetValues<View>())
            {
                data.Add(seed, view);
            }
        }

        return data;
    }
}
