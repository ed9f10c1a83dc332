using CreatureGen.Blueprints;

namespace CreatureGen.Sampling;

/// <summary>How much oftener or more rarely than usual creatures are drawn whose dominant base body is this one.</summary>
/// <param name="Name">One of <see cref="Anatomy.BaseBodyNames.All"/>.</param>
/// <param name="Weight">Factor on its usual frequency, 0..1000; 0 excludes it.</param>
public sealed record BaseBodyWeight(string Name, double Weight)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, OptionsFields.BodyWeight);
}
