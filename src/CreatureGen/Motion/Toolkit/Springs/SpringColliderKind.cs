namespace CreatureGen.Motion.Toolkit.Springs;

/// <summary>Shapes of <see cref="SpringCollider"/>.</summary>
internal enum SpringColliderKind
{
    Capsule,
    Plane,
}
