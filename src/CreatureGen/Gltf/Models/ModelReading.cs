using System;
using CreatureGen.Blueprints;

namespace CreatureGen.Gltf.Models;

/// <summary>What came of reading a model: either the model or what is wrong with the file.</summary>
public sealed class ModelReading
{
    internal ModelReading(SkinnedModel? model, Problem? problem)
    {
        Model = model;
        Problem = problem;
    }

    /// <summary>The model; null if there is a problem.</summary>
    public SkinnedModel? Model { get; }

    /// <summary>The first thing that is wrong with the file; null if there is a model.</summary>
    public Problem? Problem { get; }

    /// <summary>The model.</summary>
    /// <exception cref="InvalidOperationException">There is none; the message says why.</exception>
    public SkinnedModel GetModel() => Model ?? throw new InvalidOperationException("this model cannot be read: " + Problem);
}
