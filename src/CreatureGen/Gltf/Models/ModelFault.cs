using System;
using System.Globalization;
using CreatureGen.Blueprints;
using CreatureGen.Json;

namespace CreatureGen.Gltf.Models;

/// <summary>Ends the reading of a model at the first thing that is wrong with it. Never leaves <see cref="ModelReader"/>, which turns it into a report.</summary>
internal sealed class ModelFault : Exception
{
    public ModelFault()
        : this("model", "nothing", "a GLB file")
    {
    }

    public ModelFault(string message)
        : this("model", message, "a sound file")
    {
    }

    public ModelFault(string message, Exception inner)
        : base(message, inner) => Problem = new Problem("model", message, "a sound file");

    public ModelFault(string path, string value, string expectation)
        : base(path) => Problem = new Problem(path, value, expectation);

    /// <summary>What is wrong.</summary>
    public Problem Problem { get; }

    /// <summary>A fault at a value of the JSON.</summary>
    public static ModelFault At(JsonValue value, string expectation) => new(value.Path, value.ToString(), expectation);

    /// <summary>A fault at a member that is missing.</summary>
    public static ModelFault Missing(JsonValue parent, string name, string expectation) => new(parent.Path.Length == 0 ? name : parent.Path + "." + name, "nothing", expectation);

    /// <summary>A whole number in the invariant culture.</summary>
    public static string Text(long number) => number.ToString(CultureInfo.InvariantCulture);
}
