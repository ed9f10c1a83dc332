namespace CreatureGen.Blueprints;

/// <summary>Where a body forks into two necks with a head each. Both are those that the body has with one, turned away from each other, each the mirror image of the other.</summary>
/// <param name="Ring">Ring of the body at which it forks: behind it the body is one.</param>
/// <param name="Spread">How far each neck leans away from the midline at most, radians.</param>
/// <param name="Length">Length of both necks, relative to that of a body with one.</param>
/// <param name="Size">Size of both necks and heads, relative to those of a body with one.</param>
public sealed record ForkBlueprint(int Ring, double Spread, double Length, double Size)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, NeckFields.Fork);
}
