using System.Collections;

namespace UnityEditor;

/// <summary>Looks through the assemblies that are loaded, at each call.</summary>
public static class TypeCache
{
    public static MethodCollection GetMethodsWithAttribute<T>() where T : Attribute
    {
        const BindingFlags all = BindingFlags.Static | BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic |
            BindingFlags.DeclaredOnly;
        return new MethodCollection(Referring(typeof(T).Assembly).SelectMany(a => a.GetTypes())
            .SelectMany(t => t.GetMethods(all)).Where(m => m.IsDefined(typeof(T), false)).ToArray());
    }

    /// <summary>An assembly, and those that refer to it: no others can use what it defines.</summary>
    internal static IEnumerable<Assembly> Referring(Assembly to)
    {
        string defines = to.GetName().Name;
        return AppDomain.CurrentDomain.GetAssemblies()
            .Where(a => a == to || a.GetReferencedAssemblies().Any(r => r.Name == defines));
    }

    public struct MethodCollection
    {
        readonly MethodInfo[] m_methods;

        internal MethodCollection(MethodInfo[] methods) => m_methods = methods;

        public int Count => m_methods.Length;

        public Enumerator GetEnumerator() => new Enumerator(m_methods);

        public struct Enumerator : IEnumerator<MethodInfo>
        {
            readonly MethodInfo[] m_methods;
            int m_index;

            internal Enumerator(MethodInfo[] methods)
            {
                m_methods = methods;
                m_index = -1;
            }

            public MethodInfo Current => m_methods[m_index];
            object IEnumerator.Current => Current;

            public bool MoveNext() => ++m_index < m_methods.Length;
            void IEnumerator.Reset() => m_index = -1;
            public void Dispose() { }
        }
    }
}
