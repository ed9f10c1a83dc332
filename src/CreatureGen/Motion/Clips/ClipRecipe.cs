using System;
using CreatureGen.Motion.Toolkit;

namespace CreatureGen.Motion;

/// <summary>A clip that can be baked of a creature. Made by <see cref="ClipBaker.RecipesOf"/>.</summary>
public sealed class ClipRecipe
{
    private readonly Func<Clip> bake;

    internal ClipRecipe(string name, Func<Clip> bake)
    {
        Name = name;
        this.bake = bake;
    }

    /// <summary>The name of the clip, unique among those of its creature: <c>Idle</c>, <c>Walk</c>, <c>Start</c>, <c>Bite</c>.</summary>
    public string Name { get; }

    /// <summary>Bakes it: the same clip each time, bit for bit.</summary>
    public Clip Bake() => bake();
}
