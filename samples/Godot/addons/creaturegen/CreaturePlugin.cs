#if TOOLS
using Godot;

namespace CreatureGen.GodotAddon;

/// <summary>Offers <see cref="CreatureNode"/> in the list of nodes.</summary>
[Tool]
public partial class CreaturePlugin : EditorPlugin
{
    public override void _EnterTree() => AddCustomType("Creature", "Node3D", GD.Load<Script>("res://addons/creaturegen/CreatureNode.cs"), null);

    public override void _ExitTree() => RemoveCustomType("Creature");
}
#endif
