namespace CreatureGen.Blueprints;

/// <summary>One of two parents.</summary>
public enum ParentName
{
    /// <summary>The first.</summary>
    First,

    /// <summary>The second.</summary>
    Second,
}

/// <summary>Where a creature comes from that was bred; a record only, nothing is built by it.</summary>
/// <param name="Generation">Generations since the creatures of seeds, whose children are the first.</param>
/// <param name="First">The number by which the first parent is known (<c>BlueprintIdentity</c>).</param>
/// <param name="Second">That of the second parent.</param>
/// <param name="Mutation">Strength of its mutation, 0..1.</param>
/// <param name="Frame">Which parent gave kind, plan, limbs and posture.</param>
/// <param name="Head">Which gave the head.</param>
/// <param name="Tail">Which gave the tail.</param>
/// <param name="Ornaments">Which gave horns, hair and shell.</param>
/// <param name="Skin">Which gave cover and colours.</param>
public sealed record LineageBlueprint(int Generation, ulong First, ulong Second, double Mutation, ParentName Frame, ParentName Head, ParentName Tail, ParentName Ornaments, ParentName Skin)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, LineageFields.Lineage);
}
