// SPDX-FileCopyrightText: Copyright (c) The Biting Developers
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class   vtkBitingMesher
 * @brief   meshes a planar domain with triangles by biting squares
 *
 * vtkBitingMesher fills the inside of closed polylines with triangles whose edges are as long as a
 * spacing function f asks for. It bites squares of half-width c_b f(x) out of the domain, centred
 * on the front between what is bitten and what is left, until nothing is left. The centres are the
 * vertices of the mesh: no two are nearer than a fixed share of f, and none is farther from the
 * next than another share of it. A constrained Delaunay triangulation joins them.
 *
 * @par Steps:
 * The input is welded, split where segments meet, and divided into inside and outside by even-odd
 * parity; where BoundaryTolerance or MinimumLoopSize ask for it, it is simplified; f is prepared;
 * the vertices of the domain are bitten, then points along its edges, then the interior; the
 * centres are triangulated, with all input segments as edges; the mesh is relaxed: vertices are
 * moved, inserted and removed, and edges flipped, until triangles are well shaped and edges as long
 * as f; it is checked (orientation, area, every segment covered) and measured.
 *
 * @par Input:
 * Port 0: any vtkDataSet, by its lines and two-dimensional cells, or a composite dataset of such:
 * all blocks are one drawing, whose points and cells are numbered block after block
 * (MeshBlocksSeparately: each by itself). Lines and polylines may be merged or not, in any order
 * and orientation. Each point of a vertex cell is an embedded point, which becomes a vertex of the
 * mesh.
 * @par
 * Only lines: closed chains bound the domain, by even-odd nesting or another DomainRule; open
 * chains are interfaces, which become edges of the mesh.
 * @par
 * Two-dimensional cells (triangles, strips, quads, pixels, polygons; quadratic ones with straight
 * sides through the points of their outline): the domain is the area that an odd number of them
 * covers, whatever their orientation, so that a polygon within a polygon is a hole; DomainRule has
 * two other rules. Edges between neighbors, also where they share a part of an edge only, are
 * nothing, and points inside of the surface are no vertices of the mesh; but edges are interfaces
 * between cells that differ in RegionArray, or where KeepCellEdges is on. Where cells lie within
 * others, or overlap in part, a warning says where.
 * Lines beside cells never count for the area: on edges of the domain they carry their tags,
 * elsewhere they are interfaces. Hidden and duplicated (ghost) cells are left out. Cells with a
 * volume are refused; apply Extract Surface, Slice or Feature Edges. Curved cells of higher order
 * are refused, too.
 * @par
 * A numeric cell array `Kind` decides instead what a line or a two-dimensional cell is: 0 boundary
 * (of a line: it counts for the area by parity; a cell counts as it does without), 1 interface, 2
 * embedded points. Points that no cell uses are ignored.
 * The chains may lie in any plane: it is fitted, meshed in and mapped back. In a plane of constant
 * x, y or z the coordinates are used as they are. Points that the rounding of their coordinates
 * does not tell apart are one (MergeTolerance). Triangles are counterclockwise seen from the side
 * of the normal whose largest component is positive.
 * @par
 * Port 1, optional: any vtkDataSet with a point array, the spacing source. Images and rectilinear
 * grids of one layer are interpolated as grids; other cells with an area are triangulated and
 * projected into the plane, cells with a volume are cut by it. Hidden and ghost cells, and places
 * where the array is NaN, or `vtkValidPointMask` of a resampling 0, are no source; nor are values
 * that are zero, negative or infinite at points outside of the domain, as fill values are. Blocks
 * of a composite dataset are one source: those that have the array, of whatever numeric type; where
 * they, or cells, overlap the smallest value counts; beside cells that overlap at random f may be
 * wrong by a quarter. Where the domain reaches out of the source by more than the distance of its
 * points, a warning says what share of it, and where. The times of the output are those of all
 * inputs, so that a source that changes with time gives a mesh anew at each.
 *
 * @par Spacing:
 * f is a wanted edge length, in the units of the coordinates. It is the minimum of what is given at
 * x: UniformSpacing; the boundary array (SetBoundarySpacingArray: of points linear along chains, of
 * cells within them, growing from there with the slope Gradation); the source array
 * (SetInputArrayToProcess(1, 1, 0, POINTS, name): interpolated, and outside of the source the
 * nearest value of its border). Then it is multiplied by SpacingScale and clamped to
 * [MinimumSpacing, MaximumSpacing], lowered to the local feature size (LimitByFeatureSize), and
 * last to the largest function below all that with no slope above Gradation: within 5 % at 99 % of
 * places and 10 % anywhere, where what a source does within less than f/2 is seen by its lowest
 * value. f is never above MaximumSpacing nor below MinimumSpacing, and a source that is nowhere
 * steeper than 1.02 times Gradation is taken as it is. Slopes are limited across the
 * border of a source, too, and outside of it. Where nothing is given f is 2 % of the diagonal of
 * the domain's bounding box. An array named `Spacing` is taken where no other name was set; where
 * there is none, the only scalar point array of the source is, if it has just one; else there is no
 * such source. The name "None", or an empty one, takes no array. Any other name that does not
 * exist is an error.
 *
 * @par Output 0, the mesh:
 * Triangles; points are doubles, and vertices of the input are there bit for bit. Point data:
 * `Spacing` (f, double), `NearestNeighborDistance` (N, double), `Conformity` (min(N/f, f/N),
 * double), `BiteOrder` (int, -1 where biting stopped before, or Relaxation made the vertex),
 * `VertexKind` (unsigned char: 0 input vertex, 1 new on an input segment, 2 interior, 3 embedded
 * point), `OriginalPointId` (vtkIdType, -1 where new). Cell data: `RegionId` (int, connected faces,
 * from the leftmost one on along the boundary), `MinimumAngle` (double, degrees), `RadiusEdgeRatio`
 * (double, 0.577 is best), `AspectRatio` (double, radii of the smallest containing and the
 * inscribed circle, 2 is best). Besides these, cell data has every cell array of the
 * two-dimensional cells of port 0, of any type: at a triangle the value of the cell that covers its
 * middle; of several, by DomainRule Union the last one, else that with the smallest area; beside a
 * simplified outline the nearest one of its region. Point data has every point array of port 1
 * (TransferSourceArrays). Arrays of the names above are left out. `MinimumAngle` is the active
 * scalar, as are `Phase` of output 2 and `ProblemKind` of output 3. Field data, one value each,
 * marked vtkAbstractArray::GUI_HIDE so that programs do not offer them to colour by:
 * `NumberOfVertices`, `NumberOfTriangles`,
 * `SmallestAngle`, `LargestRadiusEdgeRatio`, `SmallestConformity`, `MeanConformity`,
 * `MeanRelativeLength` (edge length / f), `ShareOfEdgesInBand` (of [1/sqrt(2), sqrt(2)] f),
 * `GivenLipschitz` and `UsedLipschitz` (slope of the given and of the used spacing),
 * `NumberOfSharpCornerTriangles` (with an angle below 30 degrees and all vertices on the sides of
 * one corner of the input below 60 degrees: with this f they cannot be much better), and the number
 * of repairs: `RepairedDuplicatePoints`, `RepairedZeroLengthSegments`, `RepairedDuplicateSegments`,
 * `RepairedCrossings`, `RepairedTouches`, `RepairedNearPoints`, `RepairedOpenEnds`,
 * `DroppedOutsidePoints`, `DroppedOutsideInterfaces`, `OverlappingCells`; `RemovedVertices` (of the
 * input, by BoundaryTolerance), `LeftOutLoops` and `LeftOutArea` (by MinimumLoopSize),
 * `ShareOfDrawing` (share of the vertices that only the drawing asks for, 0 where it is not much
 * finer than the spacing). Field data of the input is passed on.
 * With PeriodicTranslation there is the point array `PeriodicPartner`, too.
 *
 * @par Output 1, the boundary edges:
 * Lines: the edges of the mesh that cover boundary and interfaces, those of the boundary with the
 * domain on their left, with every cell array of the input at its cell, of any type: on the outline
 * of a surface that of the cell there, where a line runs along it that of the line. Blocks of a
 * composite input are told by `BlockName` (string); where a block lacks an array its values are 0,
 * NaN or empty. Arrays of one name and of several types in blocks become one: of texts where some
 * are texts, else double where some are real, else long long; with as many components as the
 * largest has. Point data: `MeshPointId` (vtkIdType, point of
 * output 0). Cell data: `OriginalCellId` (vtkIdType), `Kind` (unsigned char, 0 boundary, 1
 * interface).
 *
 * @par Output 2, the bites (only with GenerateBites):
 * One polygon a bite, in order, and before them the front that is left, as lines. Cell data:
 * `BiteOrder` (int, -1 for the front), `Phase` (unsigned char: 0 vertex protection, 1 edge
 * protection, 2 interior, 3 front). With PreserveBoundary, bites of phase 1 are squares along
 * segments that make no vertex and keep those of the interior away. Relaxation moves vertices off
 * the centres of their bites.
 *
 * @par Output 3, the problems:
 * What was repaired or refused, to look at: one vertex cell a place, in space, also where there is
 * no mesh. The first 10 000 places of each kind are kept. Point data: `ProblemKind` (unsigned char,
 * a ProblemKindType), `IsError` (unsigned char: 0 repaired or noted, 1 prevents a mesh), `FirstId`
 * and `SecondId` (vtkIdType, -1 where there is none; ProblemKindType says what they number),
 * `Message` (string: kind, ids and place in words). Field data, by kind: `ProblemKindNames`
 * (string) and `ProblemCounts` (vtkIdType: how many there were, also those without a place). A
 * problem at a point of the input lies exactly there; a point that is not finite is shown at the
 * finite one before it in its chain, else after it. Too many vertices, parameters out of range,
 * missing arrays and cells that cannot be read have no place.
 *
 * @par Guarantees:
 * The mesh is valid (all triangles counterclockwise, decided exactly; no overlaps, no duplicate and
 * no unused points; every input segment a union of edges) or there is none. Defects of the input
 * are repaired with a warning for each kind, which says how many, which and where, or refused with
 * one error that does: no closed loop, coordinates that are not finite, points farther than 1e-6 of
 * the size, and than rounding, from one plane, a spacing that is not positive, too many vertices,
 * points without any cell. On errors the outputs are empty, but for the problems; so they are, with
 * an error, where memory does not suffice. An empty input gives empty outputs and no message.
 * An error is no failure of the pipeline, so that views show the empty outputs, not the mesh
 * before: after Update() a program learns from GetErrorCode() whether there was one,
 * vtkErrorCode::UserError, or none, vtkErrorCode::NoError.
 * Same input and parameters, same bytes: any run, number of threads and of ranks, any order of
 * points and cells; but OriginalPointId and OriginalCellId number the input, on ranks what was
 * gathered. Notes are no warnings: loops that were left out, and, without BoundaryTolerance, a
 * drawing so fine that more than half of the vertices, and five hundred at least, are there for it
 * alone, are a line of text each, through vtkOutputWindow, and counted in output 3. They are silent
 * where GlobalWarningDisplay is off.
 *
 * @par Progress and abort:
 * The progress text names the stage, from reading the input to writing the mesh; the progress grows
 * about as time goes, and is reported at each percent or tenth of a second. SetAbortExecute, from
 * an observer of the progress, stops the filter within half a second wherever it is: success, all
 * outputs empty. As with other filters the outputs count as up to date then; any change, or
 * Modified(), makes it run again.
 *
 * @par Ranks:
 * Where several processes execute the filter, each with a piece, the pieces of both inputs are
 * gathered on the first one, which makes the mesh and says what is wrong. Copies of one piece,
 * ghost cells, and cells that several pieces have count once. Cells and points keep the order of
 * their global ids, else that of the pieces: where a drawing was divided in its order, or has
 * global ids, the mesh is the serial one, byte for byte.
 * @par
 * A mesh of blocks (Cost, below) is a work of all: the first rank sends them the inputs, each
 * prepares domain and spacing, plans the same cuts and meshes its share of the blocks, which stay
 * with it. The first gets what lies along the cuts, and at segments, relaxes it, and gives each its
 * own of it; then each checks and measures its piece, and the first adds that up. What a rank does
 * not deliver at first, for want of memory or since its arithmetic differs, the first makes itself;
 * one that is lost later is an error. Without MPI in VTK's build the first makes all, and has all.
 * @par
 * So each rank has the triangles of blocks that lie together, about as many as the others, in the
 * order of the serial mesh. Point and cell data then have
 * `GlobalPointIds` and `GlobalCellIds` (vtkIdType, the active global ids), the numbers in the
 * serial mesh, and points have `vtkGhostType`: DUPLICATEPOINT where the piece of a lower rank has
 * the point, too. Ghost levels that filters behind ask for are triangles of other ranks,
 * DUPLICATECELL in the cell array `vtkGhostType`; asking for more levels later executes the filter
 * again. All other arrays are there as in the serial mesh. The other outputs, and a mesh of one
 * block, are the first rank's: the others have empty pieces with the same arrays. `MeshPointId` of
 * output 1 is the number in the serial mesh.
 * @par
 * Each rank needs memory for the inputs and its own piece, the first one for what lies along cuts
 * and segments, too; inputs of at most 2 GB can be gathered (Filters/README.md has figures). The
 * processes are those of the global vtkMultiProcessController where as many pieces are asked for;
 * one that asks for piece 0 of 1
 * works alone. All ranks have to ask for the output together. A filter before this one that reports
 * an error on some ranks alone, with success and an empty output, as ParaView's scripts do, counts
 * as an empty piece. But one whose RequestData returns 0 on some ranks alone makes the others wait
 * without end: VTK's executive does not call the filters after it there, and in the passes before,
 * in which they are called, nothing has failed yet. Only an executive of its own could tell the
 * others.
 *
 * @par Limits:
 * Where f is much larger than a gap, or its slope far above 0.3, triangles are valid but may be
 * thin; so they are in sharp angles of the input.
 *
 * @par Cost:
 * O(n log n) for n vertices; memory about 0.5 kB a vertex. Where about 128 000 vertices and more
 * are expected the domain is cut into blocks of about 64 000, which are meshed on NumberOfThreads,
 * each by itself, and then relaxed once more along the cuts; but not in the order LargestY, with
 * MaximumNumberOfBites, GenerateBites or PreserveBoundary, and without Relaxation. The check and
 * the measures of any finished mesh run on NumberOfThreads; the rest on one. Different filters may
 * run in different threads at once, also on shared input.
 *
 * @par Sources:
 * X.-Y. Li, S.-H. Teng, A. Ungor, "Biting: advancing front meets sphere packing", 2000, bites
 * circles; their follow-up "Generate good triangular meshes, conforming to control spacing
 * requirements" bites squares: sections 3.1 (the three phases) and 4.4 (phi-Delaunay). J. R.
 * Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates",
 * 1997. C. Dyken, M. Daehlen, T. Sevaldrud, "Simultaneous curve simplification", 2009 (boundary
 * tolerance). S. W. Sloan, "A fast algorithm for generating constrained Delaunay triangulations",
 * 1993.
 */

#ifndef vtkBitingMesher_h
#define vtkBitingMesher_h

#include "vtkBitingAlgorithm.h"
#include "vtkBitingCompat.h"        // for the ABI namespace
#include "vtkBitingFiltersModule.h" // for the export macro

#include "vtkSmartPointer.h" // for a choice of arrays

#include <string> // for names and the summary

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;

class VTKBITINGFILTERS_EXPORT vtkBitingMesher : public vtkBitingAlgorithm
{
public:
  static vtkBitingMesher* New();
  vtkTypeMacro(vtkBitingMesher, vtkBitingAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The values of `ProblemKind`; in brackets, what `FirstId` and `SecondId` number: points and
   * cells of the input. Those from NO_CLOSED_LOOP to CHECK_FAILED, BAD_TRIANGLES, OPEN_OUTLINES and
   * UNMATCHED_SIDES leave no mesh; the others are repaired, or only told.
   */
  enum ProblemKindType
  {
    DUPLICATE_POINTS = 0,     ///< equal coordinates, not shared (point, point)
    ZERO_LENGTH_SEGMENTS = 1, ///< (cell, point)
    DUPLICATE_SEGMENTS = 2, ///< equal or overlapping, at the start of what they share (cell, cell)
    CROSSINGS = 3,          ///< (cell, cell)
    TOUCHES = 4,            ///< a point on a segment (cell, point; -1 where a crossing made it)
    OUTSIDE_POINTS = 5,     ///< embedded, but not in the domain (point)
    OUTSIDE_INTERFACES = 6, ///< at their first end outside (cell)
    NO_CLOSED_LOOP = 7,     ///< at each open end of a chain (point)
    NOT_FINITE = 8,         ///< (point)
    OUT_OF_RANGE = 9,       ///< (point)
    NOT_PLANAR = 10,        ///< off the plane, worst first (point)
    BAD_SPACING = 11,       ///< (point of the dataset that `Message` names, input or source)
    TOO_MANY_VERTICES = 12, ///< no place
    NOT_RESOLVED = 13,      ///< where repair found no end (cell, cell)
    CHECK_FAILED = 14,      ///< a defect of this class, no place
    OVERLAPPING_CELLS = 15, ///< cells on top of others, in part (cell)
    NEAR_POINTS = 16,       ///< not to be told apart from a point or segment (point, point or -1)
    NARROW_ANGLES = 17,     ///< below 0.01 degrees: meshed as they are (cell, cell)
    RAISED_SPACING = 18,    ///< below the rounding of the coordinates, no place
    SMALL_LOOPS = 19,       ///< left out by MinimumLoopSize, at the middle of each (cell)
    FINE_DRAWING = 20,      ///< without BoundaryTolerance: it decides the mesh; no place
    BAD_TRIANGLES = 21,     ///< of vtkBitingRemesher: triangles that form no mesh (first id: cell)
    FLAT_TRIANGLES = 22,    ///< of vtkBitingRemesher: without area, mended (cell)
    JOINED_ENDS = 23,       ///< open ends that nearly touched something (point; cell)
    OPEN_OUTLINES = 24,     ///< would bound the domain, but for gaps (point; point)
    NEAR_MISSES = 25,       ///< nearer than 0.01 f, and do not meet (cell, cell)
    CHANGED_AREA = 26,      ///< by more than 5 %, by BoundaryTolerance; no place
    NESTED_CELLS = 27,      ///< cells within others, which are holes by DomainRule (cell)
    UNMATCHED_SIDES = 37    ///< that PeriodicTranslation maps in part, or beside others (cell)
  };

  enum DomainRuleType
  {
    EVEN_ODD = 0,
    OUTER_MINUS_OTHERS = 1,
    UNION = 2
  };

  enum BiteShapeType
  {
    SQUARE = 0,
    CIRCLE = 1
  };

  enum PlacementType
  {
    CORNERS = 0,
    BISECTORS = 1
  };

  enum FrontOrderType
  {
    LAYERS = 0,
    LARGEST_Y = 1,
    BEST_FIRST = 2
  };

  /**
   * The array of the input with the spacing, in units of the coordinates. A point array is linear
   * along the chains. A cell array gives the size along lines, at the points of vertex cells, and
   * anywhere in two-dimensional cells; zero and NaN ask for nothing there, and negative or infinite
   * values are errors. `association` (vtkDataObject::FIELD_ASSOCIATION_POINTS or _CELLS) says which
   * is taken where both have the name; the first three arguments, those of SetInputArrayToProcess,
   * have no effect. That method serves too, where this one was not called; but ParaView makes a
   * point array of a cell array for it where it asks for points. Default: `Spacing`, where there is
   * such an array.
   */
  void SetBoundarySpacingArray(
    int index, int port, int connection, int association, const char* name);

  ///@{
  /**
   * On (default): crossings, touches and overlaps of segments are resolved, each kind with a
   * warning. Off: they are an error that says the same.
   */
  vtkSetMacro(RepairInput, bool);
  vtkGetMacro(RepairInput, bool);
  vtkBooleanMacro(RepairInput, bool);
  ///@}

  ///@{
  /**
   * Points that are not further apart than this, relative to the diagonal of the box of the input,
   * are one, and a point that near to a segment lies on it: a warning says how many and where. In
   * [0, 1). 0 (default): only what the rounding of coordinates does not tell apart, eight units in
   * the last place of the largest one, of the type that they have: 9.5e-7 of it for floats, 1.8e-15
   * for doubles. Where a drawing of floats is smaller than its distance from the origin, 1.2e-7 of
   * the largest coordinate along each axis, and 8.3e-7 of the extent. Doubles that have been floats
   * count as floats, floats that are all whole numbers as doubles. Points are one also within
   * 7.1e-15 of the diagonal (but not points and segments): at seams of surfaces the same point is
   * computed along two ways. No vertex moves further than that; of points that are one, those of
   * boundaries stay rather than those of interfaces, and these rather than embedded ones. Other
   * values: an error.
   */
  vtkSetMacro(MergeTolerance, double);
  vtkGetMacro(MergeTolerance, double);
  ///@}

  ///@{
  /**
   * An end of an open chain within this distance of another open end, a vertex or a segment is
   * joined with it: a warning says how many, how far and where, and output 3 shows them. The end
   * moves; what it meets stays. In units of the spacing that is given there, before gradation and
   * the limit by feature size, but of no more than the diagonal of the input. At least 0; 0: ends
   * are joined within the rounding of coordinates, or MergeTolerance, only. Default 0.01. Where an
   * outline would be open else, up to ten times as much closes it. With a wider gap it is an error
   * that tells the value which closes it.
   */
  vtkSetMacro(EndTolerance, double);
  vtkGetMacro(EndTolerance, double);
  ///@}

  ///@{
  /**
   * How many triangles there are at least across channels and walls: LimitByFeatureSize leaves
   * room for so many, but does not lower the spacing below a quarter of what is given; where this
   * is above 1 and a MinimumSpacing is given, that is the only lower bound. From 1 (default) to
   * 100. Without effect where LimitByFeatureSize is off or PreserveBoundary on. What counts is the
   * distance to segments that face each other, within 45 degrees, with the domain between.
   */
  vtkSetClampMacro(CellsAcross, int, 1, 100);
  vtkGetMacro(CellsAcross, int);
  ///@}

  ///@{
  /**
   * What the domain is, of the areas that closed lines, or two-dimensional cells, enclose.
   * EVEN_ODD (default): what an odd number of them covers. OUTER_MINUS_OTHERS: the largest of them
   * less all others, also where they leave it: a box of sea less land; what lies outside of it is
   * nothing. UNION: all of them. Where they overlap the last one, by cell id, is on top; borders
   * between different ones, or of different values of RegionArray where it is given, are
   * interfaces: refinement regions in a domain, materials with priority. By the last two a loop of
   * lines is one closed polyline, or lines that are joined end to end and leave no end over; other
   * lines are interfaces. Overlaps and crossings of loops are no repairs then.
   */
  vtkSetClampMacro(DomainRule, int, EVEN_ODD, UNION);
  vtkGetMacro(DomainRule, int);
  void SetDomainRuleToEvenOdd() { this->SetDomainRule(EVEN_ODD); }
  void SetDomainRuleToOuterMinusOthers() { this->SetDomainRule(OUTER_MINUS_OTHERS); }
  void SetDomainRuleToUnion() { this->SetDomainRule(UNION); }
  ///@}

  ///@{
  /**
   * The name of a cell array of the input, of numbers or texts: edges between two-dimensional cells
   * whose values differ become edges of the mesh, and `RegionId` differs on their sides. Empty or
   * "None" (default): all cells are of one region. A name that does not exist is an error.
   */
  vtkSetStdStringFromCharMacro(RegionArray);
  vtkGetCharFromStdStringMacro(RegionArray);
  ///@}

  ///@{
  /**
   * On: every edge of a two-dimensional cell of the input is an edge of the mesh. Triangles stay
   * as they are, and those of one value of RegionArray that are neighbors are one region: so a
   * fine mesh of another program is placed into a coarse one, with the DomainRule UNION or in a
   * hole that fits. Around them f is the length of their edges, and goes to what is asked with the
   * slope Gradation. They stay where their edges are whole in the drawing and no point lies in
   * them, and no translation makes sides periodic; else, and for cells with more corners, edges
   * are divided and each cell is a region. The mesh is the first rank's. Off (default): edges
   * between cells of one region are dropped, with the vertices inside.
   */
  vtkSetMacro(KeepCellEdges, bool);
  vtkGetMacro(KeepCellEdges, bool);
  vtkBooleanMacro(KeepCellEdges, bool);
  ///@}

  ///@{
  /**
   * What a composite input is. Off (default): all of its blocks are one drawing, so that a loop in
   * one block may be a hole of another. On: each block is meshed by itself, on the rank that has
   * it, and the outputs are composite.
   */
  virtual void SetMeshBlocksSeparately(bool separately);
  vtkGetMacro(MeshBlocksSeparately, bool);
  vtkBooleanMacro(MeshBlocksSeparately, bool);
  ///@}

  ///@{
  /**
   * On: not one vertex is added on the segments of the input, boundary and interfaces; each is one
   * edge of the mesh. Off (default): they are divided as the spacing asks (paper, section 3.1, the
   * second phase). Where RepairInput resolves crossings and touches, segments still end there.
   *
   * The lengths of the segments then bound the spacing. With L(x) = min(l_i + g d_i(x)), l_i the
   * length of segment i, d_i the distance from it and g the Gradation (0.3 where it is 0), f is L
   * on the boundary, whatever else is given, and up to 2 g d above or below what L is there at a
   * distance d: a spacing much finer or coarser than the segments is reached away from them only.
   * Where nothing else is given, f is L. SpacingScale does not apply to L. Where long segments meet
   * short ones, or pass near them, triangles are valid but thin.
   */
  vtkSetMacro(PreserveBoundary, bool);
  vtkGetMacro(PreserveBoundary, bool);
  vtkBooleanMacro(PreserveBoundary, bool);
  ///@}

  ///@{
  /**
   * How far the boundary of the mesh, and its interfaces, may be from the drawing, in units of f at
   * the place, >= 0; sensible from 0.05 to 0.5. 0 (default): every vertex of the input stays. Above
   * 0 vertices of chains go that the mesh does not need:
   *
   *     drawing    /\/\/\/\_/\/\_/\/\      one edge a pixel
   *     mesh      ------+------+------     edges as long as f, within 0.2 f of the drawing
   *
   * What is left are vertices of the input, and the straight segments between them, which are
   * divided as others are. Each segment is within that distance of the path of the input that it
   * stands for, and that path of it. f is the spacing before the limit by feature size; that limit
   * then sees the simplified drawing. Topology is kept, exactly: nothing crosses or touches that
   * did not, no loop, face or channel goes. What stays: ends of chains, junctions, embedded points,
   * vertices where a line of the input has other cell data than the next, three vertices of each
   * loop, and corners (CornerAngle). No angle of the domain gets sharp by it, below 36 degrees,
   * where the drawing is blunt, however narrow the end of an inlet is. In output 1 an edge has the
   * cell data of the first segment that it stands for. A tolerance as wide as what is drawn changes
   * its area: more than 5 % is a warning. Cost O(n log n). Without effect where PreserveBoundary is
   * on. Negative or not finite: an error.
   */
  vtkSetMacro(BoundaryTolerance, double);
  vtkGetMacro(BoundaryTolerance, double);
  ///@}

  ///@{
  /**
   * With BoundaryTolerance: corners of the drawing where it turns by this or more stay where they
   * are; in degrees, 0 straight on, 90 a right angle, 180 back. The turning is seen from four
   * tolerances away (4 BoundaryTolerance f), along the boundary also beyond junctions and ends of
   * tags, so that a zigzag of pixels is no row of corners; of several corners nearer than that to
   * each other the one that turns most stays. >= 0; default 45; from 180 on none stays for its
   * angle. Smaller values keep more vertices. Negative or not finite: an error.
   */
  vtkSetMacro(CornerAngle, double);
  vtkGetMacro(CornerAngle, double);
  ///@}

  ///@{
  /**
   * Closed loops (islands, holes, lakes, closed interfaces) are left out where their larger extent
   * along the axes of the plane is below this many f, the least f on them; >= 0. 0 (default): none
   * is. A loop with the domain in it stays where anything else lies in it; any other stays where
   * something in it stays. Where there are only loops the largest stays. A note counts them, output
   * 3 shows where they were, and `LeftOutArea` is the area that they enclose. Negative or not
   * finite: an error.
   */
  vtkSetMacro(MinimumLoopSize, double);
  vtkGetMacro(MinimumLoopSize, double);
  ///@}

  ///@{
  /**
   * The shape of a bite. SQUARE (default): as in the paper, section 3.1. CIRCLE: as in its
   * predecessor (Li, Teng and Uengoer, "Biting: advancing front meets sphere packing", 2000).
   */
  vtkSetClampMacro(BiteShape, int, SQUARE, CIRCLE);
  vtkGetMacro(BiteShape, int);
  void SetBiteShapeToSquare() { this->SetBiteShape(SQUARE); }
  void SetBiteShapeToCircle() { this->SetBiteShape(CIRCLE); }
  ///@}

  ///@{
  /**
   * The biting constant c_b: half the width of a bite at x, or its radius, is c_b f(x) (paper,
   * section 3.1). Without unit, in [0.1, 1]. 0 (default): automatic, so that the mean edge length
   * of the mesh is f. Other values: an error.
   */
  vtkSetMacro(BitingConstant, double);
  vtkGetMacro(BitingConstant, double);
  ///@}

  ///@{
  /**
   * Where on the front the next bite may sit. CORNERS: at its corners, as in the paper; no
   * centre lies in an earlier bite. BISECTORS (default): over two bites, where their bisector
   * leaves both, which makes triangles nearly equilateral, 5 to 9 degrees better in the mean of
   * their smallest angles; squares are shifted from there until both new edges are as long as f
   * asks for, and turned to the bond of the two bites. A centre may then lie in an inner bite, but
   * not within 0.9 (squares) or 0.8 (circles) of its half-width. With both, nothing of the domain
   * is left without a bite.
   */
  vtkSetClampMacro(Placement, int, CORNERS, BISECTORS);
  vtkGetMacro(Placement, int);
  void SetPlacementToCorners() { this->SetPlacement(CORNERS); }
  void SetPlacementToBisectors() { this->SetPlacement(BISECTORS); }
  ///@}

  ///@{
  /**
   * Which place of the front is bitten next. LAYERS (default): first in, first out, layer by layer
   * from the boundary; with BISECTORS, places that promise good triangles before others. LARGEST_Y:
   * the one with the largest second coordinate in the plane, the sweep of the paper's section 5.
   * BEST_FIRST: the one that promises the best triangle, in 32 classes; at CORNERS the same as
   * LAYERS.
   */
  vtkSetClampMacro(FrontOrder, int, LAYERS, BEST_FIRST);
  vtkGetMacro(FrontOrder, int);
  void SetFrontOrderToLayers() { this->SetFrontOrder(LAYERS); }
  void SetFrontOrderToLargestY() { this->SetFrontOrder(LARGEST_Y); }
  void SetFrontOrderToBestFirst() { this->SetFrontOrder(BEST_FIRST); }
  ///@}

  ///@{
  /**
   * Stops after so many bites, to look at the front with GenerateBites; the mesh is that of the
   * vertices so far, without Relaxation. -1 (default): until the front is empty. Below -1: an
   * error.
   */
  vtkSetMacro(MaximumNumberOfBites, vtkIdType);
  vtkGetMacro(MaximumNumberOfBites, vtkIdType);
  ///@}

  ///@{
  /**
   * The phi of the phi-Delaunay criterion (paper, section 4.4), in (0, 1]: an edge that is not
   * Delaunay stays where neither opposite vertex lies within phi times the circumradius of the
   * circumcentre of the triangle across it, and both triangles have a radius-edge ratio of at most
   * sqrt(2) / phi: the bound of theorem 4.12 for a constant spacing, whose proof asks of all
   * vertices what definition 4.1 asks of two. 1 (default): Delaunay. Other values: an error.
   * Relaxation makes any mesh Delaunay.
   */
  vtkSetMacro(Phi, double);
  vtkGetMacro(Phi, double);
  ///@}

  ///@{
  /**
   * Where at least twice as many vertices are expected, the domain is cut into blocks of about so
   * many (Cost, above): what threads and ranks share among them. The mesh depends on it, a little;
   * with less than the default triangles are worse along the cuts. >= 0; 0: one block. Default
   * 64 000.
   */
  vtkSetClampMacro(VerticesPerBlock, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(VerticesPerBlock, vtkIdType);
  ///@}

  ///@{
  /**
   * On (default): the point arrays of the spacing source come along to the points of output 0.
   * Real numbers are interpolated by the cells of the source, of anything else the value of the
   * nearest corner counts; outside of the source that at the nearest place of its border. The array
   * `vtkValidPointMask` (unsigned char) says where: 1 inside, 0 outside. Arrays whose names are
   * those of arrays of output 0, such as `Spacing`, are left out. Off: none come along.
   */
  vtkSetMacro(TransferSourceArrays, bool);
  vtkGetMacro(TransferSourceArrays, bool);
  vtkBooleanMacro(TransferSourceArrays, bool);
  ///@}

  ///@{
  /**
   * A vector of space, in units of the coordinates, in the plane of the drawing: the period of
   * what is computed on the mesh. Zero (default): none. Sides of the boundary that it maps onto
   * others, the domain on the other side of these, are divided alike: f is there the lower one of
   * both sides, also for the gradation, and the vertices of both differ by the vector but for
   * rounding. Where a line ends at one side the other one gets a vertex, so inclusions may cross
   * the sides. The point array `PeriodicPartner` of the mesh (vtkIdType) tells the point on the
   * other side, -1 where there is none. Other parts of the boundary are free. PeriodicTranslation2
   * is a second one, with `PeriodicPartner2`: in a corner of a cell each tells the partner along
   * its own vector. (A second one alone counts as the first.) Points within four times the
   * rounding of coordinates, or MergeTolerance, of each other belong together. An error, with
   * cells and places in output 3 (UNMATCHED_SIDES): no side is mapped onto another; a line of the
   * drawing is mapped in part; a side is mapped within 1 % of the vector's length beside another,
   * at less than 10 degrees; a vector that leaves the plane by more than 1e-6 of its length. Sides
   * keep their vertices in Relaxation. With a BoundaryTolerance each side is simplified by itself,
   * and refused where they differ then. The mesh is the first rank's. Where a crack
   * (SplitInterfaces) meets a side its points have no partners.
   */
  vtkSetVector3Macro(PeriodicTranslation, double);
  vtkGetVector3Macro(PeriodicTranslation, double);
  vtkSetVector3Macro(PeriodicTranslation2, double);
  vtkGetVector3Macro(PeriodicTranslation2, double);
  ///@}

  ///@{
  /**
   * The name of a cell array of the input, of numbers: interfaces whose line, or cell where there
   * is no line, has another value than 0 there are cracks, along which the mesh opens once it is
   * made. Points on them are there twice, with the same coordinates, one for each side: the ends of
   * a crack stay single, a crack that ends at the boundary opens it, and where cracks meet there is
   * a point for each sector between them. Output 1 has the edges of both sides, each with its
   * triangle on its left. RegionId stays that of the closed mesh. Empty or "None" (default): none.
   * A name that does not exist is an error. NaN is no crack. The mesh is the first rank's.
   */
  vtkSetStdStringFromCharMacro(SplitInterfaces);
  vtkGetCharFromStdStringMacro(SplitInterfaces);
  ///@}

protected:
  vtkBitingMesher();
  ~vtkBitingMesher() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkInformation* BoundaryArrayChoice();

  vtkBitingMesher(const vtkBitingMesher&) = delete;
  void operator=(const vtkBitingMesher&) = delete;

  class Execution;

  vtkSmartPointer<vtkInformation> BoundaryArray; // null: SetInputArrayToProcess says it
  bool RepairInput = true;
  double MergeTolerance = 0.0;
  double EndTolerance = 0.01;
  int CellsAcross = 1;
  int DomainRule = EVEN_ODD;
  std::string RegionArray;
  bool KeepCellEdges = false;
  bool MeshBlocksSeparately = false;
  bool IsPassingBlocks = false; // the pipeline executes block by block
  bool PreserveBoundary = false;
  double BoundaryTolerance = 0.0;
  double CornerAngle = 45.0;
  double MinimumLoopSize = 0.0;
  int BiteShape = SQUARE;
  double BitingConstant = 0.0;
  int Placement = BISECTORS;
  int FrontOrder = LAYERS;
  vtkIdType MaximumNumberOfBites = -1;
  double Phi = 1.0;
  vtkIdType VerticesPerBlock = 64000;
  bool TransferSourceArrays = true;
  std::string SplitInterfaces;
  double PeriodicTranslation[3] = { 0.0, 0.0, 0.0 };
  double PeriodicTranslation2[3] = { 0.0, 0.0, 0.0 };
};
VTK_ABI_NAMESPACE_END

#endif
