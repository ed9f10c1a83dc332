using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Blueprints;
using CreatureGen.Limbs;
using Xunit;

namespace CreatureGen.Tests.Blueprints;

public sealed class RangeEndsTests
{
    [Theory]
    [InlineData(false, Explicit = true)]
    [InlineData(true)]
    public void Any_one_number_may_go_to_the_end_of_its_range_and_the_creature_still_grows(bool greatest)
    {
        int grown = 0;
        foreach (CreatureBlueprint blueprint in Samples.Drawn(1).Append(Samples.Small))
        {
            for (int number = 0; ; number += Thoroughness.IsExhaustive ? 1 : 3)
            {
                var pusher = new NumberPusher(number, greatest);
                CreatureBlueprint pushed = CreatureFields.Creature.Visit(pusher, blueprint);
                if (pusher.Pushed is null)
                {
                    break;
                }

                // Some ends do not go with the rest of a creature; the validator says so.
                if (BlueprintValidator.Validate(pushed).Count == 0)
                {
                    GrownSurface surface = GrownSurface.Grow(pushed);
                    Assert.True(surface.Surface.Positions.All(IsFinite) && surface.Appendages.SelectMany(limb => limb.Joints).All(IsFinite), pusher.Pushed);
                    grown++;
                }
            }
        }

        Assert.InRange(grown, Thoroughness.Of(600), Thoroughness.Of(2000));
    }

    private static bool IsFinite(Vector3 point) => float.IsFinite(point.X) && float.IsFinite(point.Y) && float.IsFinite(point.Z);

    /// <summary>Puts one number of a record to an end of its range.</summary>
    private sealed class NumberPusher(int target, bool greatest) : IFieldVisitor
    {
        private int count;

        /// <summary>The name of the number; null if the record has fewer numbers.</summary>
        public string? Pushed { get; private set; }

        public IFieldVisitor Since(int format) => this;

        public double Number(string name, double value, NumberRange range) => IsTarget(name) ? (greatest ? range.Maximum : range.Minimum) : value;

        public int Whole(string name, int value, WholeRange range) => IsTarget(name) ? (greatest ? range.Maximum : range.Minimum) : value;

        public int Version(string name, int value, int current) => value;

        public ulong UnsignedText(string name, ulong value) => value;

        public ulong? OptionalText(string name, ulong? value) => value;

        public TEnum Choice<TEnum>(string name, TEnum value, ChoiceNames<TEnum> names)
            where TEnum : struct, Enum => value;

        public string Word(string name, string value, IReadOnlyList<string> known) => value;

        public T Record<T>(string name, T value, RecordDescription<T> description)
            where T : class, IEquatable<T> => description.Visit(this, value);

        public T? Optional<T>(string name, T? value, RecordDescription<T> description)
            where T : class, IEquatable<T> => value;

        public ValueList<T> List<T>(string name, ValueList<T> value, WholeRange count, RecordDescription<T> description)
            where T : class, IEquatable<T> => new(value.Select(item => description.Visit(this, item)).ToArray());

        private bool IsTarget(string name)
        {
            if (count++ != target)
            {
                return false;
            }

            Pushed = name;
            return true;
        }
    }
}
