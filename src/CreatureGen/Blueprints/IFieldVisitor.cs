using System;
using System.Collections.Generic;

namespace CreatureGen.Blueprints;

/// <summary>
/// Goes through the fields of a record. The one description of a record tells every visitor the name, the value and the range of each field and builds a new
/// record from what the visitor returns: a writer returns the value it was given, a reader the one in the text.
/// </summary>
internal interface IFieldVisitor
{
    /// <summary>The visitor for a field that older text does not have: <c>visit.Since(3).Number(…)</c>. Where the text is of an older format, the field has the value of the neutral record.</summary>
    /// <param name="format">The first format of <see cref="BlueprintFormat"/> with the field.</param>
    IFieldVisitor Since(int format);

    /// <summary>A number.</summary>
    double Number(string name, double value, NumberRange range);

    /// <summary>A whole number.</summary>
    int Whole(string name, int value, WholeRange range);

    /// <summary>A version: a whole number from 1 to the library's own.</summary>
    int Version(string name, int value, int current);

    /// <summary>A whole number of 64 bits; in JSON, whose numbers are doubles to many, a string of its decimal digits.</summary>
    ulong UnsignedText(string name, ulong value);

    /// <summary>The same, or nothing at all: a field that is left out.</summary>
    ulong? OptionalText(string name, ulong? value);

    /// <summary>One of the values of an enumeration.</summary>
    TEnum Choice<TEnum>(string name, TEnum value, ChoiceNames<TEnum> names)
        where TEnum : struct, Enum;

    /// <summary>One of a number of known words.</summary>
    string Word(string name, string value, IReadOnlyList<string> known);

    /// <summary>A record.</summary>
    T Record<T>(string name, T value, RecordDescription<T> description)
        where T : class, IEquatable<T>;

    /// <summary>A record, or nothing at all: a field that is left out.</summary>
    T? Optional<T>(string name, T? value, RecordDescription<T> description)
        where T : class, IEquatable<T>;

    /// <summary>A list of records.</summary>
    ValueList<T> List<T>(string name, ValueList<T> value, WholeRange count, RecordDescription<T> description)
        where T : class, IEquatable<T>;
}
