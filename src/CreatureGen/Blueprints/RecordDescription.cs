using System;
using CreatureGen.Json;

namespace CreatureGen.Blueprints;

/// <summary>The fields of a record: their names in JSON, their order and their ranges.</summary>
/// <typeparam name="T">The record.</typeparam>
internal sealed class RecordDescription<T>
    where T : class, IEquatable<T>
{
    private readonly Func<IFieldVisitor, T, T> fields;

    /// <summary>Describes a record.</summary>
    /// <param name="neutral">A record whose fields are in range; a reader takes its values where the text has none.</param>
    /// <param name="layout">How its text is set out within indented text.</param>
    /// <param name="fields">Shows the visitor each field of the given record once, and builds a record of what it returns.</param>
    public RecordDescription(T neutral, JsonLayout layout, Func<IFieldVisitor, T, T> fields)
    {
        Neutral = neutral;
        Layout = layout;
        this.fields = fields;
    }

    /// <summary>A record whose fields are in range.</summary>
    public T Neutral { get; }

    /// <summary>How its text is set out within indented text.</summary>
    public JsonLayout Layout { get; }

    /// <summary>Shows the visitor each field of a record and returns what it makes of them.</summary>
    public T Visit(IFieldVisitor visitor, T value) => fields(visitor, value);
}
