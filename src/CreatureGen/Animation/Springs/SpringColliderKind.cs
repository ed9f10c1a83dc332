namespace CreatureGen.Animation.Springs;

/// <summary>Shapes of <see cref="SpringCollider"/>.</summary>
internal enum SpringColliderKind
{
    Capsule,
    Plane,
}
