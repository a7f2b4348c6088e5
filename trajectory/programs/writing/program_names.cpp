// SPDX-License-Identifier: Apache-2.0
#include "trajectory/programs/writing/program_names.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <set>

namespace hapticell::trajectory {

namespace {

using Words = std::set<std::string, std::less<>>;

Words wordsIn(std::string_view list) {
  Words words;
  std::string word;
  for (const char c : list) {
    if (c != ' ' && c != '\n') {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!word.empty()) {
      words.insert(std::move(word));
      word.clear();
    }
  }
  if (!word.empty()) words.insert(std::move(word));
  return words;
}

// Keywords as in KUKA's "Expert Programming" and in the grammar of KRL; then types, standard functions, and modules
// that every controller has.
constexpr std::string_view kKrlWords = R"(
and anin anout b_and b_exor b_not b_or bool brake c_dis c_ori c_ptp c_spl c_vel case cast_from cast_to ccd char circ circ_rel
confirm const const_key continue decl def default defdat deffct delay do else end enddat endfct endfor endif endloop
endspline endswitch endwhile enum error exit exor ext extfct extp false for global go goto halt if import in int interrupt is
lin lin_rel loop maximum minimum not off on or out prio ptp ptp_rel ptp_spline public real repeat return scirc scirc_rel sec
signal slin slin_rel spl spl_rel spline sptp sptp_rel step struc switch then time_block to trigger true until wait when while
with axis e6axis frame pos e3pos e3axis e6pos load inertia ldat pdat fdat tool_data base_data
abs sin cos tan acos asin atan2 sqrt forward inverse inv_pos varstate cread cwrite copen cclose sread swrite pulse clear_msg
on_error_proceed toolcal bas sps cell user p00 ir_stopm msg_demo user_grp userspot new_serv diag masref_user)";

// "RAPID kernel", section Reserved words; then data types, instructions, functions and data that are installed.
constexpr std::string_view kRapidWords = R"(
alias and backward case connect const default div do else elseif endfor endfunc endif endmodule endproc endrecord endtest
endtrap endwhile error exit false for from func goto if inout local mod module nostepin not noview or pers proc raise
readonly record retry return step sysmodule task test then to trap true trynext undo var viewonly while with xor
num dnum bool string byte pos orient pose robjoint extjoint robtarget jointtarget confdata speeddata zonedata tooldata
wobjdata loaddata clock intnum iodev signaldi signaldo signalai signalao signalgi signalgo errnum stoppointdata
movej movel movec moveabsj movejdo moveldo movecdo triggj triggl triggc searchl searchc movelsync movejsync accset velset
confj confl waittime waitdi waitdo waituntil set reset setdo setao setgo pulsedo invertdo tpwrite tperase tpreadfk tpreadnum
stop exitcycle incr decr add clear clkstart clkstop clkreset clkread offs reltool crobt cjointt ctool cwobj abs sin cos tan
asin acos atan atan2 sqrt pow exp round trunc dim distance dotprod eulerzyx orientzyx posemult poseinv posevect valtostr
numtostr strtoval strlen strpart strfind gettime opmode isnum calcrobt calcjointt mirpos nmir defframe singarea softact
softdeact gripload actunit deactunit pdispset pdispon pdispoff eoffson eoffsoff
tool0 wobj0 load0 fine z0 z1 z5 z10 z15 z20 z30 z40 z50 z60 z80 z100 z150 z200 vmax v5 v10 v20 v30 v40 v50 v60 v80 v100 v150
v200 v300 v400 v500 v600 v800 v1000 v1500 v2000 v2500 v3000 v4000 v5000 v6000 v7000 pi main vline base user event
rapid_template)";

// Names of devices and states that the controller's file system refuses.
constexpr std::string_view kFanucWords = R"(
con prn aux nul com1 com2 com3 com4 com5 com6 com7 com8 com9 lpt1 lpt2 lpt3 lpt4 lpt5 lpt6 lpt7 lpt8 lpt9 bckedt call jmp lbl
end wait if select for endfor else then run pause abort)";

// Keywords of the URScript manual, and the functions and constants that a program of that name would hide.
constexpr std::string_view kUrScriptWords = R"(
and as assert break continue def elif else end enter_critical exit_critical false global halt if in is join kill lambda local loop
not or p pass return run sec struct thread true while xor none pi
movej movel movep movec servoj servoc speedj speedl stopj stopl stopc set_tcp set_payload set_gravity set_target_payload
get_actual_tcp_pose get_actual_joint_positions get_target_tcp_pose get_target_joint_positions get_inverse_kin
get_forward_kin pose_trans pose_add pose_sub pose_inv pose_dist point_dist interpolate_pose popup textmsg sleep sync
set_digital_out set_analog_out set_tool_digital_out get_digital_in set_standard_digital_out get_standard_digital_in
socket_open socket_close socket_send_string socket_read_ascii_float force_mode end_force_mode freedrive_mode
end_freedrive_mode teach_mode end_teach_mode conveyor_pulse_decode track_conveyor_linear stop_conveyor_tracking abs acos
asin atan atan2 ceil cos d2r exp floor log norm pow r2d random sin size sqrt tan length to_num to_str str_cat str_len
integer_to_binary_list binary_list_to_integer write_output_integer_register read_input_integer_register powerdown
protective_stop is_steady is_within_safety_limits path_offset_enable rpc_factory modbus_add_signal zero_ftsensor)";

constexpr std::string_view kVal3Words = R"(
and as begin bool break call case config const default do end else elseif endfor endif endswitch endwhile false flange for
frame global if joint jointrx jointrs local mdesc not num or point pointrx pointrs private procedure program public return
step string switch then to tool trsf true until user while world xor dio aio sio start stop
abs accel acos align appro asin atan autoconnectmove blend call_app chr close cls compose cos delay del disablepower distance
enablepower exp get gotoxy here herej insert interpolatec interpolatel isdefault isempty isinrange jointtopoint left len
link log ln max min mid mnextsettling movec movej movel open pointtojoint popupmsg position power put putln resetmotion
restartmove reversejoint right round roundup rounddown select setframe setwrist sin size speed sqrt stopmove taskcreate
taskkill taskresume taskstatus tan tonum tostring trsfalign userpage wait waitendmove ppoint jstart mmotion mstart ttool
fbase)";

constexpr std::string_view kInformWords = R"(
nop end call jump ret if movj movl movc movs mover imov refp speed timer dout din wait pause abort inc dec add sub mul div
set sete getp getpos clear cos sin sqrt and or not xor until label con prn aux nul)";

const Words& wordsOf(ProgramFormat format) {
  static const Words kKrl = wordsIn(kKrlWords), kRapid = wordsIn(kRapidWords), kFanuc = wordsIn(kFanucWords);
  static const Words kUr = wordsIn(kUrScriptWords), kVal3 = wordsIn(kVal3Words), kInform = wordsIn(kInformWords);
  switch (format) {
    case ProgramFormat::kKrl:
      return kKrl;
    case ProgramFormat::kRapid:
      return kRapid;
    case ProgramFormat::kFanuc:
      return kFanuc;
    case ProgramFormat::kUrScript:
      return kUr;
    case ProgramFormat::kVal3:
      return kVal3;
    case ProgramFormat::kInform:
      return kInform;
  }
  return kKrl;
}

/// "p12" for "p".
bool isNumbered(std::string_view name, std::string_view stem) {
  return name.size() > stem.size() && name.starts_with(stem) &&
         std::all_of(name.begin() + static_cast<std::ptrdiff_t>(stem.size()), name.end(),
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// Base letters of U+00C0 to U+017F, in order; '*' for the signs that are no letters.
constexpr std::string_view kBaseLetters =
    "AAAAAAACEEEEIIIIDNOOOOO*OUUUUYTsaaaaaaaceeeeiiiidnooooo*ouuuuyty"
    "AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIiIiJjKkkLlLlLlLlLlNnNnNnnNnOoOoOoOoRrRrRrSsSsSsSsTtTtTtUuUuUuUuUu"
    "UuWwYyY"
    "ZzZzZzs";
static_assert(kBaseLetters.size() == 0x180 - 0xC0);

std::string letterOf(std::uint32_t sign) {
  if (sign < 128) return std::isalnum(static_cast<int>(sign)) != 0 ? std::string(1, static_cast<char>(sign)) : "_";
  if (sign < 0xC0 || sign >= 0x180) return "_";
  const char base = kBaseLetters[sign - 0xC0];
  return std::string(1, base == '*' ? '_' : base);
}

/// One sign of UTF-8 at `i`, which moves on; an invalid byte counts as one.
std::uint32_t takeSign(const std::string& text, std::size_t& i) {
  const auto first = static_cast<unsigned char>(text[i++]);
  if (first < 0xC0) return first < 128 ? first : 0xFFFD;
  const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
  std::uint32_t sign = first & (0x3FU >> more);
  for (int k = 0; k < more; ++k) {
    if (i >= text.size() || (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) return 0xFFFD;
    sign = (sign << 6U) | (static_cast<unsigned char>(text[i++]) & 0x3FU);
  }
  return sign;
}

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return std::tolower(c); });
  return result;
}

}  // namespace

std::size_t longestProgramName(ProgramFormat format) {
  switch (format) {
    case ProgramFormat::kKrl:
      return 24;
    case ProgramFormat::kRapid:
    case ProgramFormat::kInform:  // DX100 and later; 8 before
      return 32;
    case ProgramFormat::kFanuc:  // R-30iA and later take 36; 30 as their file names
      return 30;
    case ProgramFormat::kUrScript:
      return 60;
    case ProgramFormat::kVal3:
      return 15;
  }
  return 8;
}

bool isReservedName(std::string_view name, ProgramFormat format) {
  const std::string word = lower(name);
  if (wordsOf(format).contains(word)) return true;
  if (format == ProgramFormat::kKrl) return isNumbered(word, "xp");
  return format == ProgramFormat::kRapid && isNumbered(word, "p");
}

std::string programName(const std::string& wanted, ProgramFormat format) {
  std::string name;
  for (std::size_t i = 0; i < wanted.size();) name += letterOf(takeSign(wanted, i));
  const auto isLetter = [](unsigned char c) { return std::isalpha(c) != 0; };
  if (std::none_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) != 0; })) name = "program";
  if (!isLetter(static_cast<unsigned char>(name.front()))) name.insert(0, "p");
  name.resize(std::min(name.size(), longestProgramName(format)));
  // Twice, as cutting may end in another reserved word.
  for (int i = 0; i < 2 && isReservedName(name, format); ++i) {
    name.insert(0, "p_");
    name.resize(std::min(name.size(), longestProgramName(format)));
  }
  if (format == ProgramFormat::kFanuc || format == ProgramFormat::kInform) {
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
  }
  return name;
}

}  // namespace hapticell::trajectory
